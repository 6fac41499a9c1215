import { join } from 'node:path';
import { emitCodec } from './emit-codec.ts';
import { emitFileDescriptors } from './emit-file-descriptors.ts';
import { emitMessages } from './emit-messages.ts';
import { emitSchema } from './emit-schema.ts';
import { loadRoot, loadSchema } from './load-schema.ts';

/** The message that recordings hold. */
const RECORD = 'ubii.topicData.TopicDataRecord';

/**
 * Every generated file: path relative to the package, and source. Depends on nothing but the schema.
 *
 * @param packageFolder absolute path of packages/proto
 */
export function generatedFiles(packageFolder: string): Map<string, string> {
  const folder = join(packageFolder, 'schema');
  const schema = loadSchema(folder);
  return new Map([
    ['src/generated/messages.ts', emitMessages(schema)],
    ['src/generated/codec.ts', emitCodec(schema)],
    ['src/generated/schema.ts', emitSchema(schema)],
    ['src/generated/record-schema.ts', emitFileDescriptors(loadRoot(folder), RECORD, folder)],
  ]);
}
