import { messageDescriptor, type FieldDescriptor, type MessageDescriptor } from '../descriptor.ts';

/** How the bytes of a field are checked. */
export type Check =
  | typeof VARINT
  | typeof FIXED64
  | typeof FIXED32
  | typeof STRING
  | typeof BYTES
  | typeof MESSAGE;
export const VARINT = 0;
export const FIXED64 = 1;
export const STRING = 2;
export const BYTES = 3;
export const MESSAGE = 4;
export const FIXED32 = 5;

/** A field in the structure check. */
export interface FieldCheck {
  readonly number: number;
  readonly check: Check;
  /** Wire type of a single value. */
  readonly wireType: number;
  /** A repeated number may come as a length-delimited block of numbers. */
  readonly isPackable: boolean;
  /** The nested message, for MESSAGE. */
  readonly message: MessageCheck | undefined;
  /** A value of the record. */
  readonly isOneofMember: boolean;
}

/** A message in the structure check. */
export interface MessageCheck {
  readonly name: string;
  /** By field number, up to LOW_FIELDS. An array, because this is looked up once per field received. */
  readonly low: readonly (FieldCheck | undefined)[];
  /** By field number, beyond it. */
  readonly high: ReadonlyMap<number, FieldCheck>;
}

/** Field numbers below this one are looked up in an array; the schema's highest is 44. */
export const LOW_FIELDS = 64;

/** Builds the tables of a message and of all messages within. */
export function messageCheck(type: string): MessageCheck {
  return build(messageDescriptor(type), new Map());
}

function build(
  { name, fields }: MessageDescriptor,
  known: Map<string, MessageCheck>,
): MessageCheck {
  const before = known.get(name);
  if (before !== undefined) return before;
  const low = new Array<FieldCheck | undefined>(LOW_FIELDS).fill(undefined);
  const high = new Map<number, FieldCheck>();
  for (const field of fields) {
    const entry = fieldCheck(field, known);
    if (field.number < LOW_FIELDS) low[field.number] = entry;
    else high.set(field.number, entry);
  }
  const message = { name, low, high };
  known.set(name, message);
  return message;
}

function fieldCheck(field: FieldDescriptor, known: Map<string, MessageCheck>): FieldCheck {
  const { number, oneof, repeated, type } = field;
  const isMessage = typeof type === 'object' && type.kind === 'message';
  const check = isMessage ? MESSAGE : typeof type === 'object' ? VARINT : SCALAR_CHECKS[type];
  const wireType = WIRE_TYPES[check];
  return {
    number,
    check,
    wireType,
    isPackable: repeated && wireType !== 2,
    message: isMessage ? build(type, known) : undefined,
    isOneofMember: oneof !== undefined,
  };
}

const SCALAR_CHECKS = {
  double: FIXED64,
  float: FIXED32,
  int32: VARINT,
  int64: VARINT,
  bool: VARINT,
  string: STRING,
  bytes: BYTES,
} as const;

const WIRE_TYPES: { readonly [C in Check]: number } = {
  [VARINT]: 0,
  [FIXED64]: 1,
  [STRING]: 2,
  [BYTES]: 2,
  [MESSAGE]: 2,
  [FIXED32]: 5,
};
