/** Emits the descriptor table: one line a field, read by src/descriptor.ts. */
import { HEADER } from './emit-messages.ts';
import { isEnum, isMessage, type FieldModel, type SchemaModel } from './load-schema.ts';

/** Source of src/generated/schema.ts. */
export function emitSchema(schema: SchemaModel): string {
  const lines: string[] = [];
  for (const { fullName, values } of schema.enums) {
    lines.push(`enum ${fullName}`, ...values.map((value) => `${value.number} ${value.name}`));
  }
  for (const { fullName, fields } of schema.messages) {
    lines.push(`message ${fullName}`, ...fields.map(fieldLine));
  }
  return `${HEADER}
/**
 * The whole schema as text, because it is small, compresses well and diffs line by line:
 * \`enum <full name>\` and its \`<number> <name>\` lines, \`message <full name>\` and its
 * \`<number> <name> <type>[ *][ <oneof>]\` lines; \`*\` marks a repeated field.
 */
export const SCHEMA_TEXT = \`
${lines.join('\n')}
\`;
`;
}

function fieldLine({ number, name, type, repeated, oneof }: FieldModel): string {
  const typeName = isMessage(type) || isEnum(type) ? type.fullName : type;
  return [number, name, typeName, repeated ? '*' : undefined, oneof]
    .filter((part) => part !== undefined)
    .join(' ');
}
