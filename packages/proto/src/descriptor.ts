import { SCHEMA_TEXT } from './generated/schema.ts';

/** Kinds of values that are neither messages nor enums. */
export type ScalarType = 'double' | 'float' | 'int32' | 'int64' | 'bool' | 'string' | 'bytes';

/** An enum of the schema. */
export interface EnumDescriptor {
  readonly kind: 'enum';
  /** Full name, `ubii.clients.Client.State`. */
  readonly name: string;
  readonly numberByName: ReadonlyMap<string, number>;
  readonly nameByNumber: ReadonlyMap<number, string>;
}

/** A field of a message. */
export interface FieldDescriptor {
  readonly number: number;
  /** Name in the schema, snake_case. */
  readonly protoName: string;
  /** Name in JSON and in decoded objects, lowerCamelCase. */
  readonly jsonName: string;
  readonly type: ScalarType | EnumDescriptor | MessageDescriptor;
  readonly repeated: boolean;
  /** Name in the schema of the oneof it belongs to. */
  readonly oneof: string | undefined;
}

/** A message of the schema. */
export interface MessageDescriptor {
  readonly kind: 'message';
  /** Full name, `ubii.clients.Client`. */
  readonly name: string;
  /** In the order of their numbers. */
  readonly fields: readonly FieldDescriptor[];
  readonly fieldByNumber: ReadonlyMap<number, FieldDescriptor>;
  /** By JSON name and by schema name. */
  readonly fieldByName: ReadonlyMap<string, FieldDescriptor>;
}

/** Fields from this number on are extensions of ours. */
export const FIRST_EXTENSION_FIELD = 1000;

interface Schema {
  readonly messages: ReadonlyMap<string, MessageDescriptor>;
  readonly enums: ReadonlyMap<string, EnumDescriptor>;
}

interface OpenMessage {
  readonly descriptor: MessageDescriptor;
  readonly fields: FieldDescriptor[];
  readonly lines: string[];
}

/** Reads the text format described at SCHEMA_TEXT. */
function parseSchema(text: string): Schema {
  const enums = new Map<string, EnumDescriptor>();
  const messages = new Map<string, OpenMessage>();
  let addLine: (line: string) => void = () => undefined;
  for (const line of text.trim().split('\n')) {
    const [first = '', name = ''] = line.split(' ');
    if (first === 'enum') {
      const numberByName = new Map<string, number>();
      const nameByNumber = new Map<number, string>();
      enums.set(name, { kind: 'enum', name, numberByName, nameByNumber });
      addLine = (value) => {
        const [number = '', valueName = ''] = value.split(' ');
        numberByName.set(valueName, Number(number));
        nameByNumber.set(Number(number), valueName);
      };
    } else if (first === 'message') {
      const message = openMessage(name);
      messages.set(name, message);
      addLine = (field) => message.lines.push(field);
    } else {
      addLine(line);
    }
  }
  for (const { descriptor, fields, lines } of messages.values()) {
    for (const line of lines) {
      const field = parseField(line, (type) => messages.get(type)?.descriptor ?? enums.get(type));
      fields.push(field);
      (descriptor.fieldByNumber as Map<number, FieldDescriptor>).set(field.number, field);
      (descriptor.fieldByName as Map<string, FieldDescriptor>)
        .set(field.protoName, field)
        .set(field.jsonName, field);
    }
  }
  return { messages: new Map([...messages].map(([name, m]) => [name, m.descriptor])), enums };
}

function openMessage(name: string): OpenMessage {
  const fields: FieldDescriptor[] = [];
  return {
    fields,
    lines: [],
    descriptor: {
      kind: 'message',
      name,
      fields,
      fieldByNumber: new Map(),
      fieldByName: new Map(),
    },
  };
}

function parseField(
  line: string,
  typeNamed: (name: string) => MessageDescriptor | EnumDescriptor | undefined,
): FieldDescriptor {
  const [number = '', protoName = '', type = '', ...rest] = line.split(' ');
  const repeated = rest[0] === '*';
  return {
    number: Number(number),
    protoName,
    jsonName: protoName.replace(/_+(.)/g, (_match, letter: string) => letter.toUpperCase()),
    type: typeNamed(type) ?? (type as ScalarType),
    repeated,
    oneof: rest[repeated ? 1 : 0],
  };
}

const SCHEMA = parseSchema(SCHEMA_TEXT);

/** Every message of the schema by its full name. */
export const MESSAGES = SCHEMA.messages;

/** Every enum of the schema by its full name. */
export const ENUMS = SCHEMA.enums;

/**
 * Descriptor of a message.
 *
 * @throws RangeError when the schema has no such message
 */
export function messageDescriptor(type: string): MessageDescriptor {
  const descriptor = MESSAGES.get(type);
  if (descriptor === undefined) throw new RangeError(`the schema has no message ${type}`);
  return descriptor;
}
