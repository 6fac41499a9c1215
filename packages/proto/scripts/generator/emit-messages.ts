/** Emits interfaces and enum objects with the comments of the schema. */
import {
  isEnum,
  isMessage,
  type EnumModel,
  type FieldModel,
  type MessageModel,
  type SchemaModel,
} from './load-schema.ts';

export const HEADER =
  '// Made from schema/*.proto by scripts/generate.ts. Change the schema, then run `pnpm generate`.\n';

/** Source of src/generated/messages.ts. */
export function emitMessages(schema: SchemaModel): string {
  const parts = [HEADER];
  for (const enumeration of schema.enums) parts.push(emitEnum(enumeration));
  for (const message of schema.messages) parts.push(emitInterface(message));
  parts.push(
    '/** Every message of the schema by its full name. */',
    'export interface MessageTypes {',
    ...schema.messages.map((message) => `  '${message.fullName}': ${message.tsName};`),
    '}\n',
  );
  return parts.join('\n');
}

function emitEnum({ fullName, tsName, comment, values }: EnumModel): string {
  const lines = [...docLines(`${comment}\n\n\`${fullName}\``, ''), `export const ${tsName} = {`];
  for (const value of values) {
    lines.push(...docLines(value.comment, '  '), `  ${value.name}: ${value.number},`);
  }
  lines.push(
    '} as const;',
    `export type ${tsName} = (typeof ${tsName})[keyof typeof ${tsName}];`,
    '',
  );
  return lines.join('\n');
}

function emitInterface({ fullName, tsName, comment, fields }: MessageModel): string {
  const lines = [...docLines(`${comment}\n\n\`${fullName}\``, ''), `export interface ${tsName} {`];
  for (const field of fields) {
    lines.push(...docLines(field.comment, '  '));
    const type = tsTypeOf(field.type);
    if (field.repeated) lines.push(`  ${field.jsonName}: ${type}[];`);
    else if (field.oneof !== undefined) lines.push(`  ${field.jsonName}?: ${type} | undefined;`);
    else if (isMessage(field.type)) lines.push(`  ${field.jsonName}: ${type} | undefined;`);
    else lines.push(`  ${field.jsonName}: ${type};`);
  }
  lines.push('}', '');
  return lines.join('\n');
}

/** TypeScript type of one value of a field. */
export function tsTypeOf(type: FieldModel['type']): string {
  if (isMessage(type) || isEnum(type)) return type.tsName;
  if (type === 'string') return 'string';
  if (type === 'bool') return 'boolean';
  if (type === 'bytes') return 'Uint8Array';
  return 'number';
}

function docLines(comment: string, indent: string): string[] {
  const text = comment.trim().replaceAll('*/', '* /');
  if (text === '') return [];
  const lines = text.split('\n').map((line) => line.trim());
  if (lines.length === 1) return [`${indent}/** ${lines[0]} */`];
  return [`${indent}/**`, ...lines.map((line) => `${indent} * ${line}`.trimEnd()), `${indent} */`];
}
