import { expectMcap, readIndex } from '../mcap/read-index.ts';
import { salvage } from '../mcap/salvage.ts';
import { RecordingReader } from '../reading/recording-reader.ts';
import type { RecordingFile } from '../storage/recording-storage.ts';

/** What was saved of a damaged file. */
export interface Repair {
  /** From the first record to the last that is whole, nanoseconds. */
  readonly durationNs: bigint;
  readonly records: number;
  /** Time of the last record that is whole: later ones may be missing. Undefined without records. */
  readonly lostAfterNs: bigint | undefined;
  /** Bytes at the end that were cut off. */
  readonly cutBytes: number;
}

/**
 * Gives a file without its end indexes and footer in place; what is behind the last whole chunk is cut off.
 *
 * @returns undefined when the file is whole
 * @throws RecordingError when the file is no MCAP file
 */
export async function repairRecording(file: RecordingFile): Promise<Repair | undefined> {
  await expectMcap(file);
  if ((await readIndex(file)) !== undefined) return undefined;
  const { keptBytes, end } = await salvage(file);
  const size = await file.size();
  await file.truncate(keptBytes);
  await file.write(end);
  const reader = await RecordingReader.open(file);
  const { startNs, endNs, records } = reader.summary;
  return {
    durationNs: endNs - startNs,
    records,
    lostAfterNs: records > 0 ? endNs : undefined,
    cutBytes: Number(size - keptBytes),
  };
}
