/** Emits one encode and one decode function a message. Fields are written in the order of their numbers. */
import { HEADER, tsTypeOf } from './emit-messages.ts';
import {
  isEnum,
  isMessage,
  type FieldModel,
  type MessageModel,
  type SchemaModel,
} from './load-schema.ts';

/** Fields whose zero is not written, although it was given. */
const ZERO_LEFT_OUT = new Set([
  // Existing Node.js nodes exit when they meet an explicit 0 here.
  'ubii.processing.ProcessingModule.language',
]);

const WIRE_TYPE = {
  double: 1,
  float: 5,
  int32: 0,
  int64: 0,
  bool: 0,
  string: 2,
  bytes: 2,
} as const;

/** Source of src/generated/codec.ts. */
export function emitCodec(schema: SchemaModel): string {
  return [
    HEADER,
    "import type { Init } from '../init.ts';",
    "import { only, open, readBytes, readInt64, setMember, skip, writeBytes, writeString, type Reader, type Writer } from '../protobuf.ts';",
    "import type * as T from './messages.ts';",
    '',
    ...schema.messages.flatMap((message) => [emitEncode(message), emitDecode(message)]),
    '/** Both directions of every message by its full name. */',
    'export const CODECS: {',
    '  readonly [K in keyof T.MessageTypes]: {',
    '    readonly encode: (m: Init<T.MessageTypes[K]>, w: Writer) => void;',
    '    readonly decode: (r: Reader) => T.MessageTypes[K];',
    '  };',
    '} = {',
    ...schema.messages.map(
      ({ fullName, tsName }) =>
        `  '${fullName}': { encode: encode${tsName}, decode: decode${tsName} },`,
    ),
    '};',
    '',
  ].join('\n');
}

function emitEncode(message: MessageModel): string {
  const lines = [
    `export function encode${message.tsName}(${message.fields.length > 0 ? 'm' : '_m'}: Init<T.${message.tsName}>, ${message.fields.length > 0 ? 'w' : '_w'}: Writer): void {`,
  ];
  for (const field of message.fields) {
    const member = `m.${field.jsonName}`;
    if (field.repeated) {
      lines.push(...encodeRepeated(field));
      continue;
    }
    const zeroLeftOut = ZERO_LEFT_OUT.has(`${message.fullName}.${field.name}`);
    const given = `${member} != null${zeroLeftOut ? ` && ${member} !== 0` : ''}`;
    lines.push(`  if (${given}) ${writeValue(field, member)}`);
  }
  return [...lines, '}', ''].join('\n');
}

function encodeRepeated(field: FieldModel): string[] {
  const member = `m.${field.jsonName}`;
  if (isPackable(field)) {
    const method = methodOf(field);
    // The writer's types want a mutable array, which it does not change.
    const list = `${member} as ${method === 'bool' ? 'boolean' : 'number'}[]`;
    return [
      `  if (${member} != null && ${member}.length > 0) w.uint32(${tagOf(field, 2)}).${method}s(${list});`,
    ];
  }
  return [`  if (${member} != null) for (const e of ${member}) ${writeValue(field, 'e')}`];
}

function writeValue(field: FieldModel, value: string): string {
  const tag = tagOf(field, wireTypeOf(field));
  const { type } = field;
  if (isMessage(type)) {
    return `{ w.uint32(${tag}).fork(); encode${type.tsName}(${value}, w); w.ldelim(); }`;
  }
  if (type === 'bytes') return `writeBytes(w.uint32(${tag}), ${value});`;
  if (type === 'string') return `writeString(w.uint32(${tag}), ${value});`;
  return `w.uint32(${tag}).${methodOf(field)}(${value});`;
}

function emitDecode(message: MessageModel): string {
  const { tsName, fields } = message;
  const oneofs = [...new Set(fields.flatMap((field) => field.oneof ?? []))];
  const lines = oneofs.map(
    (oneof) => `const ${oneofKeys(message, oneof)} = [${members(message, oneof)}] as const;`,
  );
  lines.push(
    `export function decode${tsName}(r: Reader, into?: T.${tsName}): T.${tsName} {`,
    `  const m: T.${tsName} = into ?? ${defaults(message)};`,
    ...oneofs.map(
      (oneof) => `  let ${oneof} = into && setMember(into, ${oneofKeys(message, oneof)});`,
    ),
    '  while (r.pos < r.len) {',
    '    const tag = r.tag();',
    '    switch (tag) {',
  );
  for (const field of fields) lines.push(...decodeCases(field));
  lines.push('      default: skip(r, tag);', '    }', '  }', '  return m;', '}', '');
  return lines.join('\n');
}

function decodeCases(field: FieldModel): string[] {
  const member = `m.${field.jsonName}`;
  const only =
    field.oneof === undefined
      ? ''
      : `${field.oneof} = only(m, ${field.oneof}, '${field.jsonName}'); `;
  const single = `      case ${tagOf(field, wireTypeOf(field))}: ${only}`;
  if (isMessage(field.type)) {
    const call = `decode${field.type.tsName}`;
    const store = field.repeated
      ? `${member}.push(${call}(r));`
      : `${member} = ${call}(r, ${member});`;
    return [`${single}{ const end = open(r); ${store} r.len = end; break; }`];
  }
  if (!field.repeated) return [`${single}${member} = ${readValue(field)}; break;`];
  const cases = [`${single}${member}.push(${readValue(field)}); break;`];
  if (isPackable(field)) {
    cases.push(`      case ${tagOf(field, 2)}: r.${methodOf(field)}s(${member}); break;`);
  }
  return cases;
}

function readValue(field: FieldModel): string {
  const { type } = field;
  if (isEnum(type)) return `r.int32() as T.${type.tsName}`;
  if (type === 'string') return 'r.stringVerify()';
  if (type === 'bytes') return 'readBytes(r)';
  if (type === 'int64') return 'readInt64(r)';
  return `r.${methodOf(field)}()`;
}

function methodOf({ type }: FieldModel): string {
  return isEnum(type) ? 'int32' : (type as string);
}

function isPackable(field: FieldModel): boolean {
  return field.repeated && !isMessage(field.type) && wireTypeOf(field) !== 2;
}

function wireTypeOf({ type }: FieldModel): number {
  if (isMessage(type)) return 2;
  return isEnum(type) ? 0 : WIRE_TYPE[type];
}

function tagOf({ number }: FieldModel, wireType: number): number {
  return ((number << 3) | wireType) >>> 0;
}

function oneofKeys({ tsName }: MessageModel, oneof: string): string {
  return `${tsName}_${oneof}`;
}

function members({ fields }: MessageModel, oneof: string): string {
  return fields
    .filter((field) => field.oneof === oneof)
    .map((field) => `'${field.jsonName}'`)
    .join(', ');
}

function defaults({ fields }: MessageModel): string {
  const parts = fields
    .filter((field) => field.oneof === undefined)
    .map((field) => `${field.jsonName}: ${defaultOf(field)}`);
  return parts.length === 0 ? '{}' : `{ ${parts.join(', ')} }`;
}

function defaultOf({ type, repeated }: FieldModel): string {
  if (repeated) return '[]';
  if (isMessage(type)) return 'undefined';
  const ts = isEnum(type) ? 'number' : tsTypeOf(type);
  return { string: "''", boolean: 'false', number: '0', Uint8Array: 'new Uint8Array(0)' }[ts]!;
}
