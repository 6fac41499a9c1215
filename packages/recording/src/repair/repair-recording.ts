import { expectMcap, readIndex } from '../mcap/open-file.ts';
import { salvage } from '../mcap/salvage.ts';
import { RecordingReader } from '../reading/recording-reader.ts';
import { RecordingError } from '../records/recording-error.ts';
import type { RecordingEvent } from '../records/recording-event.ts';
import type { RecordingHeader } from '../records/recording-header.ts';
import type { RecordingFile } from '../storage/recording-storage.ts';
import { RecordingWriter } from '../writing/recording-writer.ts';

/** Result of the repair of a damaged file. */
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

/** Changes of a recording that is complete. */
export interface RecordingChange {
  readonly events?: readonly RecordingEvent[];
  /** Replaces the header. */
  readonly header?: RecordingHeader;
}

/**
 * Appends to a recording that is complete. When the file cannot be written, it stays as it was; when the process ends
 * meanwhile, it can be repaired.
 *
 * @throws RecordingError when the file is not whole; the error of the file when that cannot be written
 */
export async function changeRecording(
  file: RecordingFile,
  { events = [], header }: RecordingChange,
): Promise<void> {
  const whole = await readIndex(file);
  if (whole === undefined) throw new RecordingError('The recording has no end. Repair it first.');
  const { index, dataEnd } = whole;
  const end = await file.read(dataEnd, (await file.size()) - dataEnd);
  await file.truncate(dataEnd);
  try {
    const writer = RecordingWriter.resume(file, index);
    for (const event of events) writer.addEvent(event);
    if (header !== undefined) await writer.setHeader(header);
    await writer.end();
  } catch (error) {
    await file.truncate(dataEnd);
    await file.write(end);
    throw error;
  }
}
