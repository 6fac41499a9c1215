import type { RecordedRecord } from '../records/recorded-record.ts';
import type { RecordingEvent } from '../records/recording-event.ts';
import type { RecordingHeader } from '../records/recording-header.ts';
import { RecordingWriter } from '../writing/recording-writer.ts';
import { MemoryFile } from './memory-file.ts';
import { SAMPLE_HEADER } from './sample-records.ts';

/** A complete recording of records and events in memory. */
export async function recorded(
  records: Iterable<RecordedRecord>,
  events: Iterable<RecordingEvent> = [],
  header: Partial<RecordingHeader> = {},
): Promise<MemoryFile> {
  const file = new MemoryFile();
  const writer = await RecordingWriter.create(file, { ...SAMPLE_HEADER, ...header });
  for (const event of events) writer.addEvent(event);
  for (const record of records) await writer.addRecord(record);
  await writer.end();
  return file;
}
