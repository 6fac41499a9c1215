import type { EventsReader } from '../reading/recording-reader.ts';
import type { RecordingSink } from '../storage/recording-storage.ts';
import { RecordingWriter } from '../writing/recording-writer.ts';
import { TreatedReader } from './treated-reader.ts';
import type { Treatment } from './treatment.ts';

/** How a recording is treated. */
export interface TreatOptions {
  readonly signal?: { throwIfAborted(): void };
  /** Told now and then: records written so far. */
  readonly onProgress?: (records: number) => void;
}

/** Records between two messages of progress. */
const PROGRESS_RECORDS = 1000;

/**
 * Writes a recording as it is shared to the start of a sink. Nothing is copied that did not pass the treatment: other
 * metadata and attachments stay behind, snapshots of last values are made of treated records.
 *
 * @returns how many records were written
 * @throws the error of the sink, or the reason of `options.signal` when it is aborted
 */
export async function treatRecording(
  reader: EventsReader,
  sink: RecordingSink,
  treatment: Treatment,
  { signal, onProgress }: TreatOptions = {},
): Promise<number> {
  const treated = new TreatedReader(reader, treatment);
  const writer = await RecordingWriter.create(sink, treatment.header(reader.summary));
  const events = await treated.events();
  let next = 0;
  let count = 0;
  for await (const record of treated.records()) {
    signal?.throwIfAborted();
    // Clients are named before their records.
    while (next < events.length && events[next]!.timeNs <= record.logTimeNs) {
      writer.addEvent(events[next++]!);
    }
    await writer.addRecord(record);
    if (++count % PROGRESS_RECORDS === 0) onProgress?.(count);
  }
  for (const event of events.slice(next)) writer.addEvent(event);
  await writer.end();
  onProgress?.(count);
  return count;
}
