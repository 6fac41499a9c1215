import { join } from 'node:path';
import { emitCodec } from './emit-codec.ts';
import { emitMessages } from './emit-messages.ts';
import { emitSchema } from './emit-schema.ts';
import { loadSchema } from './load-schema.ts';

/**
 * Every generated file: path relative to the package, and source. Depends on nothing but the schema.
 *
 * @param packageFolder absolute path of packages/proto
 */
export function generatedFiles(packageFolder: string): Map<string, string> {
  const schema = loadSchema(join(packageFolder, 'schema'));
  return new Map([
    ['src/generated/messages.ts', emitMessages(schema)],
    ['src/generated/codec.ts', emitCodec(schema)],
    ['src/generated/schema.ts', emitSchema(schema)],
  ]);
}
