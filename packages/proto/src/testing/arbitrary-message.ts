import fc from 'fast-check';
import { messageDescriptor, type FieldDescriptor, type MessageDescriptor } from '../descriptor.ts';

/** Which messages to make. */
export interface ArbitraryMessageOptions {
  /** Fields with this number or a higher one are left out. */
  readonly belowField?: number;
}

/** Text of characters that take 1, 2, 3 and 4 bytes of UTF-8, the first and last of each among them. */
const text = fc.oneof(
  { arbitrary: fc.string({ maxLength: 60 }), weight: 3 },
  fc
    .array(
      fc.constantFrom('\0', 'a', '\x7f', '\x80', 'ä', '\u07ff', '\u0800', '€', '\uffff', '😀'),
      {
        maxLength: 12,
      },
    )
    .map((characters) => characters.join('')),
);

/** Messages as `decode` returns them: all scalars there, at most one member of a oneof. */
export function arbitraryMessage(
  type: string,
  options: ArbitraryMessageOptions = {},
): fc.Arbitrary<Record<string, unknown>> {
  return messageArbitrary(messageDescriptor(type), options.belowField ?? Infinity, 0);
}

function messageArbitrary(
  type: MessageDescriptor,
  belowField: number,
  depth: number,
): fc.Arbitrary<Record<string, unknown>> {
  const fields = type.fields.filter((field) => field.number < belowField);
  const plain = fields.filter((field) => field.oneof === undefined);
  const oneofs = [...new Set(fields.flatMap((field) => field.oneof ?? []))];
  const record = fc.record(
    Object.fromEntries(
      plain.map((field) => [field.jsonName, memberArbitrary(field, belowField, depth)]),
    ),
  );
  const choices = oneofs.map((oneof) =>
    fc.oneof(
      fc.constant({}),
      ...fields
        .filter((field) => field.oneof === oneof)
        .map((field) =>
          valueArbitrary(field, belowField, depth).map((value) => ({ [field.jsonName]: value })),
        ),
    ),
  );
  return fc
    .tuple(record, ...choices)
    .map((parts) => Object.assign({}, ...parts) as object) as fc.Arbitrary<Record<string, unknown>>;
}

function memberArbitrary(
  field: FieldDescriptor,
  belowField: number,
  depth: number,
): fc.Arbitrary<unknown> {
  const value = valueArbitrary(field, belowField, depth);
  if (field.repeated) return fc.array(value, { maxLength: depth > 1 ? 1 : 3 });
  const isMessage = typeof field.type === 'object' && field.type.kind === 'message';
  return isMessage ? fc.option(value, { nil: undefined }) : value;
}

function valueArbitrary(
  field: FieldDescriptor,
  belowField: number,
  depth: number,
): fc.Arbitrary<unknown> {
  const { type } = field;
  if (typeof type === 'object') {
    return type.kind === 'message'
      ? messageArbitrary(type, belowField, depth + 1)
      : fc.constantFrom(...type.nameByNumber.keys());
  }
  switch (type) {
    case 'double':
      return fc.double();
    case 'float':
      return fc.float();
    case 'int32':
      return fc.integer();
    case 'int64':
      return fc.maxSafeInteger();
    case 'bool':
      return fc.boolean();
    case 'string':
      return text;
    case 'bytes':
      return fc.uint8Array({ maxLength: 40 });
  }
}
