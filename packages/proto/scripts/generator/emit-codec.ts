/**
 * Emits one encode and one decode function for each message that topic data can carry. Fields are written in the order
 * of their numbers. All other messages are encoded and decoded from the schema table, see src/table-codec.ts.
 */
import { HEADER, tsTypeOf } from './emit-messages.ts';
import {
  isEnum,
  isMessage,
  type FieldModel,
  type MessageModel,
  type SchemaModel,
} from './load-schema.ts';

/** Hot messages: this one, and all that it can hold at any depth. */
const HOT_ROOT = 'ubii.topicData.TopicData';
/** Not hot, although topic data can hold them: they describe clients, sessions and recordings, and change rarely. */
const COLD = new Set([
  'ubii.clients.Client',
  'ubii.devices.Component',
  'ubii.devices.ComponentList',
  'ubii.devices.Device',
  'ubii.devices.DeviceList',
  'ubii.extension.ModuleEvent',
  'ubii.extension.ModuleReports',
  'ubii.extension.RecordingStatus',
  'ubii.extension.SessionStatistics',
  'ubii.sessions.Session',
  'ubii.sessions.SessionList',
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
  const within = messagesWithin(schema, HOT_ROOT);
  const hot = within.filter(isHot);
  return [
    HEADER,
    "import { only, setMember } from '../binary/oneof.ts';",
    "import type { Reader } from '../binary/reader.ts';",
    "import { skipField } from '../binary/skip-field.ts';",
    "import type { Writer } from '../binary/writer.ts';",
    "import type { Init } from '../init.ts';",
    "import { tableCodec, type CodecOf } from '../table-codec.ts';",
    "import type * as T from './messages.ts';",
    '',
    ...within
      .filter((message) => !isHot(message))
      .map(({ fullName, tsName }) => `const ${tsName} = tableCodec('${fullName}');`),
    '',
    ...hot.flatMap((message) => [emitEncode(message), emitDecode(message)]),
    '/** The generated functions by the full name of their message. */',
    'export const GENERATED_CODECS = {',
    ...hot.map(
      ({ fullName, tsName }) =>
        `  '${fullName}': { encode: encode${tsName}, decode: decode${tsName} },`,
    ),
    '} as const satisfies { readonly [K in keyof T.MessageTypes]?: CodecOf<K> };',
    '',
  ].join('\n');
}

/** A message and those that it can hold, by name; of cold ones nothing more. */
function messagesWithin({ messages }: SchemaModel, root: string): MessageModel[] {
  const found = new Set<MessageModel>();
  const visit = (message: MessageModel): void => {
    found.add(message);
    if (!isHot(message)) return;
    for (const { type } of message.fields) if (isMessage(type)) visit(type);
  };
  visit(messages.find(({ fullName }) => fullName === root)!);
  return messages.filter((message) => found.has(message));
}

function isHot({ fullName }: MessageModel): boolean {
  return !COLD.has(fullName);
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
    lines.push(`  if (${member} != null) ${writeValue(field, member)}`);
  }
  return [...lines, '}', ''].join('\n');
}

function encodeRepeated(field: FieldModel): string[] {
  const member = `m.${field.jsonName}`;
  if (isPackable(field)) {
    const call = `w.${methodOf(field)}s(${tagOf(field, 2)}, ${member})`;
    return [`  if (${member} != null && ${member}.length > 0) ${call};`];
  }
  return [`  if (${member} != null) for (const e of ${member}) ${writeValue(field, 'e')}`];
}

function writeValue(field: FieldModel, value: string): string {
  const tag = tagOf(field, wireTypeOf(field));
  const { type } = field;
  return isMessage(type)
    ? `{ const at = w.open(${tag}); ${functionOf('encode', type)}(${value}, w); w.close(at); }`
    : `w.${methodOf(field)}(${tag}, ${value});`;
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
    '  while (r.pos < r.end) {',
    '    const tag = r.tag();',
    '    switch (tag) {',
  );
  for (const field of fields) lines.push(...decodeCases(field));
  lines.push('      default: skipField(r, tag);', '    }', '  }', '  return m;', '}', '');
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
    const call = functionOf('decode', field.type);
    const store = field.repeated
      ? `${member}.push(${call}(r));`
      : `${member} = ${call}(r, ${member});`;
    return [`${single}{ const end = r.enter(); ${store} r.end = end; break; }`];
  }
  if (!field.repeated) return [`${single}${member} = ${readValue(field)}; break;`];
  const cases = [`${single}${member}.push(${readValue(field)}); break;`];
  if (isPackable(field)) {
    cases.push(`      case ${tagOf(field, 2)}: r.${methodOf(field)}s(${member}); break;`);
  }
  return cases;
}

function readValue(field: FieldModel): string {
  const call = `r.${methodOf(field)}()`;
  return isEnum(field.type) ? `${call} as T.${field.type.tsName}` : call;
}

function functionOf(direction: 'encode' | 'decode', message: MessageModel): string {
  return isHot(message) ? `${direction}${message.tsName}` : `${message.tsName}.${direction}`;
}

/** Reader and writer name their methods after the types of the schema. */
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
