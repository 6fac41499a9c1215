import { RecordingError } from '../records/recording-error.ts';
import type { RecordingSource } from '../storage/recording-storage.ts';
import type { FileIndex } from './file-index.ts';

const RECORD_HEAD_BYTES = 9;

/** Reads the last metadata record of a name; empty when there is none. @throws RecordingError when it is broken */
export async function readMetadata(
  source: RecordingSource,
  index: FileIndex,
  name: string,
): Promise<ReadonlyMap<string, string>> {
  const entry = index.metadata.findLast((candidate) => candidate.name === name);
  if (entry === undefined) return new Map();
  const record = await source.read(entry.offset, entry.length);
  try {
    return parseMetadata(record.subarray(RECORD_HEAD_BYTES));
  } catch (cause) {
    throw new RecordingError(`The metadata "${name}" is broken.`, { cause });
  }
}

/** The name and the size of the map in bytes, then keys and values: texts with their lengths before them. */
function parseMetadata(content: Uint8Array): Map<string, string> {
  const view = new DataView(content.buffer, content.byteOffset, content.byteLength);
  const decoder = new TextDecoder();
  let pos = 0;
  const text = (): string => {
    const start = pos + 4;
    pos = start + view.getUint32(pos, true);
    return decoder.decode(content.subarray(start, pos));
  };
  text();
  pos += 4;
  const metadata = new Map<string, string>();
  while (pos < content.length) metadata.set(text(), text());
  return metadata;
}
