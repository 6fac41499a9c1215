import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import { generatedFiles } from './generator/generated-files.ts';
import { loadSchema } from './generator/load-schema.ts';

const packageFolder = join(fileURLToPath(import.meta.url), '..', '..');

describe('the generated code', () => {
  it.each([...generatedFiles(packageFolder)])('%s is up to date', (path, source) => {
    expect(readFileSync(join(packageFolder, path), 'utf8')).toBe(source);
  });

  it('is the same in every run', () => {
    expect(generatedFiles(packageFolder)).toEqual(generatedFiles(packageFolder));
  });
});

describe('the schema', () => {
  it('says what every message, field, enum and value means', () => {
    const { enums, messages } = loadSchema(join(packageFolder, 'schema'));
    const silent = [
      ...messages.flatMap(({ fullName, comment, fields }) => [
        ...(comment === '' ? [fullName] : []),
        ...fields.filter((field) => field.comment === '').map(({ name }) => `${fullName}.${name}`),
      ]),
      ...enums.flatMap(({ fullName, comment, values }) => [
        ...(comment === '' ? [fullName] : []),
        ...values.filter((value) => value.comment === '').map(({ name }) => `${fullName}.${name}`),
      ]),
    ];
    expect(silent).toEqual([]);
  });
});
