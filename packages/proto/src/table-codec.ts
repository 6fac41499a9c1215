import type { Reader } from './binary/reader.ts';
import { skipField } from './binary/skip-field.ts';
import type { Writer } from './binary/writer.ts';
import {
  messageDescriptor,
  MESSAGES,
  type FieldDescriptor,
  type MessageDescriptor,
  type ScalarType,
} from './descriptor.ts';
import type { MessageTypes } from './generated/messages.ts';
import type { Init } from './init.ts';

/** Encodes and decodes a message. */
export interface Codec<Argument, Result> {
  readonly encode: (message: Argument, writer: Writer) => void;
  /** @param into a message to merge into, for a member that comes more than once */
  readonly decode: (reader: Reader, into?: Result) => Result;
}

/** The codec of a message by its full name. */
export type CodecOf<T extends keyof MessageTypes> = Codec<Init<MessageTypes[T]>, MessageTypes[T]>;

type Values = Record<string, unknown>;
type Write = (writer: Writer, value: unknown) => void;
type Read = (reader: Reader, before?: unknown) => unknown;
type ReadMember = (reader: Reader, message: Values) => void;

const WIRE_TYPES = { double: 1, float: 5, int32: 0, int64: 0, bool: 0, string: 2, bytes: 2 };
/** Wire type of texts, bytes, messages and packed lists. */
const DELIMITED = 2;
/** Methods of reader and writer for packed lists. The generator refuses lists of `int64`. */
const PACKED = { double: 'doubles', float: 'floats', int32: 'int32s', bool: 'bools' } as const;

/** Existing Node.js nodes exit when they meet an explicit 0 here. */
const ZERO_LEFT_OUT = 'ubii.processing.ProcessingModule.language';

const CODECS = new Map(
  [...MESSAGES.values()].map((message) => [message.name, codecFor(message)] as const),
);

/**
 * The codec of a message that follows the schema table at run time. It encodes and decodes as the generated functions
 * do, with less code to load and more time for each message.
 *
 * @throws RangeError when the schema has no such message
 */
export function tableCodec<T extends keyof MessageTypes>(type: T): CodecOf<T> {
  return nestedCodec(messageDescriptor(type)) as unknown as CodecOf<T>;
}

function nestedCodec({ name }: MessageDescriptor): Codec<Values, Values> {
  return CODECS.get(name)!;
}

/** Prepares the fields at the first use: most messages are never used by a page. */
function codecFor({ name: type, fields }: MessageDescriptor): Codec<Values, Values> {
  let writes: (readonly [name: string, write: Write])[] | undefined;
  let reads: ReadonlyMap<number, ReadMember> | undefined;
  let empty: (() => Values) | undefined;
  return {
    encode(message, writer) {
      writes ??= fields.map((field) => [field.jsonName, writeMember(type, field)]);
      for (const [name, write] of writes) {
        const value = message[name];
        if (value !== undefined && value !== null) write(writer, value);
      }
    },
    decode(reader, into) {
      reads ??= new Map(fields.flatMap((field) => readMember(field, fields)));
      empty ??= emptyMessage(fields);
      const message = into ?? empty();
      while (reader.pos < reader.end) {
        const tag = reader.tag();
        const read = reads.get(tag);
        if (read === undefined) skipField(reader, tag);
        else read(reader, message);
      }
      return message;
    },
  };
}

function writeMember(message: string, field: FieldDescriptor): Write {
  const packed = packedMethod(field);
  if (packed !== undefined) {
    const tag = tagOf(field, DELIMITED);
    return (writer, list) => {
      if ((list as ArrayLike<unknown>).length > 0) writer[packed](tag, list as never);
    };
  }
  const write = writeValue(field);
  if (`${message}.${field.protoName}` === ZERO_LEFT_OUT) {
    return (writer, value) => value !== 0 && write(writer, value);
  }
  if (!field.repeated) return write;
  return (writer, list) => {
    for (const element of list as Iterable<unknown>) write(writer, element);
  };
}

function writeValue(field: FieldDescriptor): Write {
  const { type } = field;
  const tag = tagOf(field);
  if (isMessage(type)) {
    const { encode } = nestedCodec(type);
    return (writer, value) => {
      const opened = writer.open(tag);
      encode(value as Values, writer);
      writer.close(opened);
    };
  }
  const method = scalarOf(type);
  return (writer, value) => writer[method](tag, value as never);
}

/** How a member is read, by tag: lists of numbers may be packed or not. */
function readMember(
  field: FieldDescriptor,
  fields: readonly FieldDescriptor[],
): [tag: number, read: ReadMember][] {
  const { jsonName: name, oneof, repeated } = field;
  const read = readValue(field);
  const tag = tagOf(field);
  if (!repeated) {
    const rivals = fields.filter((other) => other.oneof === oneof && other !== field);
    const unset = oneof === undefined ? undefined : new Set(rivals.map((rival) => rival.jsonName));
    return [
      [
        tag,
        (reader, message) => {
          if (unset !== undefined) unsetMembers(message, unset);
          message[name] = read(reader, message[name]);
        },
      ],
    ];
  }
  const list = (message: Values): never[] => message[name] as never[];
  const single: ReadMember = (reader, message) => list(message).push(read(reader) as never);
  const packed = packedMethod(field);
  if (packed === undefined) return [[tag, single]];
  const block: ReadMember = (reader, message) => reader[packed](list(message));
  return [
    [tag, single],
    [tagOf(field, DELIMITED), block],
  ];
}

function readValue({ type }: FieldDescriptor): Read {
  if (isMessage(type)) {
    const { decode } = nestedCodec(type);
    return (reader, before) => {
      const outerEnd = reader.enter();
      const message = decode(reader, before as Values | undefined);
      reader.end = outerEnd;
      return message;
    };
  }
  const method = scalarOf(type);
  return (reader) => reader[method]();
}

/** Members of a oneof are there only when they are set, so there are few to look at. */
function unsetMembers(message: Values, members: ReadonlySet<string>): void {
  for (const name in message) if (members.has(name)) delete message[name];
}

/** Creates messages without values. Copying one is faster than setting members one by one. */
function emptyMessage(fields: readonly FieldDescriptor[]): () => Values {
  const plain = fields.filter(({ oneof }) => oneof === undefined);
  const empty = Object.fromEntries(plain.map((field) => [field.jsonName, defaultOf(field)]));
  const owned = plain.filter(({ repeated, type }) => repeated || type === 'bytes');
  return () => {
    const message = { ...empty };
    for (const field of owned) message[field.jsonName] = defaultOf(field);
    return message;
  };
}

function defaultOf({ type, repeated }: FieldDescriptor): unknown {
  if (repeated) return [];
  if (isMessage(type)) return undefined;
  switch (scalarOf(type)) {
    case 'string':
      return '';
    case 'bool':
      return false;
    case 'bytes':
      return new Uint8Array(0);
    default:
      return 0;
  }
}

function isMessage(type: FieldDescriptor['type']): type is MessageDescriptor {
  return typeof type === 'object' && type.kind === 'message';
}

/** Reader and writer name their methods after the types of the schema; enums are `int32`. */
function scalarOf(type: Exclude<FieldDescriptor['type'], MessageDescriptor>): ScalarType {
  return typeof type === 'object' ? 'int32' : type;
}

function packedMethod({ type, repeated }: FieldDescriptor) {
  if (!repeated || isMessage(type)) return undefined;
  const scalar = scalarOf(type);
  return scalar in PACKED ? PACKED[scalar as keyof typeof PACKED] : undefined;
}

function tagOf({ number, type }: FieldDescriptor, wireType?: number): number {
  const own = isMessage(type) ? DELIMITED : WIRE_TYPES[scalarOf(type)];
  return ((number << 3) | (wireType ?? own)) >>> 0;
}
