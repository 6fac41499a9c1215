import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  isEnum,
  isMessage,
  loadSchema,
  type EnumModel,
  type FieldModel,
} from '../scripts/generator/load-schema.ts';
import { decode, encode, type MessageType } from './codec.ts';
import { ENUMS, FIRST_EXTENSION_FIELD, MESSAGES } from './descriptor.ts';
import { arbitraryMessage } from './testing/arbitrary-message.ts';
import { toHex } from './testing/hex.ts';
import {
  decodePublished,
  PUBLISHED_SCHEMA_FOLDER,
  publishedMessage,
} from './testing/published-formats.ts';

const packageFolder = join(fileURLToPath(import.meta.url), '..', '..');
const ours = loadSchema(join(packageFolder, 'schema'));
const theirs = loadSchema(PUBLISHED_SCHEMA_FOLDER);

function fieldLine({ number, name, type, repeated, oneof }: FieldModel): string {
  const typeName = typeof type === 'string' ? type : type.fullName;
  return `${number} ${name} ${typeName}${repeated ? ' repeated' : ''} ${oneof ?? ''}`.trim();
}

function enumLines({ values }: EnumModel): string[] {
  return values.map(({ number, name }) => `${number} ${name}`);
}

describe('the schema and the published message formats', () => {
  it('have the same packages, messages and enums, ours in ubii.extension aside', () => {
    const names = (schema: typeof ours): string[] =>
      [...schema.messages, ...schema.enums]
        .map(({ fullName }) => fullName)
        .filter((name) => !name.startsWith('ubii.extension.'))
        .sort();
    expect(names(ours)).toEqual(names(theirs));
  });

  it.each(theirs.messages.map((message) => [message.fullName, message] as const))(
    '%s has the same fields: numbers, names, types, labels, oneofs',
    (name, message) => {
      const fields = ours.messages.find(({ fullName }) => fullName === name)!.fields;
      expect(fields.filter(({ number }) => number < FIRST_EXTENSION_FIELD).map(fieldLine)).toEqual(
        message.fields.map(fieldLine),
      );
    },
  );

  it.each(theirs.enums.map((enumeration) => [enumeration.fullName, enumeration] as const))(
    '%s has the same values',
    (name, enumeration) => {
      const found = ours.enums.find(({ fullName }) => fullName === name)!;
      expect(enumLines(found)).toEqual(enumLines(enumeration));
    },
  );
});

describe('the descriptor table and the schema', () => {
  it('describe the same messages', () => {
    expect([...MESSAGES.keys()]).toEqual(ours.messages.map(({ fullName }) => fullName));
    expect([...ENUMS.keys()]).toEqual(ours.enums.map(({ fullName }) => fullName));
    for (const { fullName, fields } of ours.messages) {
      const described = MESSAGES.get(fullName)!.fields.map(
        ({ number, protoName, jsonName, type, repeated, oneof }) => ({
          number,
          name: protoName,
          jsonName,
          type: typeof type === 'string' ? type : type.name,
          repeated,
          oneof,
        }),
      );
      expect(described).toEqual(
        fields.map(({ number, name, jsonName, type, repeated, oneof }) => ({
          number,
          name,
          jsonName,
          type: isMessage(type) || isEnum(type) ? type.fullName : type,
          repeated,
          oneof,
        })),
      );
    }
  });
});

describe('encoding, compared with the published module', () => {
  const types = theirs.messages.map(({ fullName }) => fullName as MessageType);

  it.each(types)('%s: same bytes, same contents both ways', (type) => {
    const published = publishedMessage(type)!;
    const messages = arbitraryMessage(type, { belowField: FIRST_EXTENSION_FIELD });
    fc.assert(
      fc.property(messages, (message) => {
        withoutCpp(message);
        const bytes = encode(type, message as never);
        expect(toHex(published.encode(message).finish())).toBe(toHex(bytes));
        // The published module does not know our fields, so its result is a part of ours.
        expect(decode(type, bytes)).toMatchObject(decodePublished(published, bytes));
      }),
      { numRuns: 30 },
    );
  });
});

/** Language 0 is the one value we do not write as the published module does. */
function withoutCpp(value: unknown): void {
  if (typeof value !== 'object' || value === null) return;
  if ((value as { language?: number }).language === 0)
    delete (value as { language?: number }).language;
  Object.values(value).forEach(withoutCpp);
}
