import type { RecordingSource } from '../storage/recording-storage.ts';
import type { FileIndex } from './file-index.ts';
import { expectMcap, readIndex } from './read-index.ts';
import { salvage } from './salvage.ts';

/** A file that can be read by its index. */
export interface OpenFile {
  readonly index: FileIndex;
  readonly source: RecordingSource;
  /** The end of the file is missing, and was rebuilt in memory. */
  readonly isDamaged: boolean;
}

/** Opens a file by its index, which is rebuilt when the file has none. @throws RecordingError when it is no MCAP file */
export async function openFile(source: RecordingSource): Promise<OpenFile> {
  await expectMcap(source);
  const whole = await readIndex(source);
  if (whole !== undefined) return { index: whole.index, source, isDamaged: false };
  return { index: (await salvage(source)).index, source, isDamaged: true };
}
