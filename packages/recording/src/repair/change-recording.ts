import { readIndex } from '../mcap/read-index.ts';
import { RecordingError } from '../records/recording-error.ts';
import type { RecordingEvent } from '../records/recording-event.ts';
import type { RecordingHeader } from '../records/recording-header.ts';
import type { RecordingFile } from '../storage/recording-storage.ts';
import { RecordingWriter } from '../writing/recording-writer.ts';

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
