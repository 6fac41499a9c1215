import { cutRecording, type CutOptions } from '../cut/cut-recording.ts';
import type { EventsReader } from '../reading/recording-reader.ts';
import type { RecordingSink } from '../storage/recording-storage.ts';
import type { WriterStatistics } from '../writing/recording-writer.ts';
import { TreatedReader } from './treated-reader.ts';
import type { Treatment } from './treatment.ts';

/**
 * Writes a recording, or a part of it, as it is shared. Nothing is copied that did not pass the treatment: other metadata and
 * attachments stay behind, snapshots of last values are made of treated records.
 *
 * @param options topics and span as they are shared, see `TreatedReader`
 * @throws RecordingError when nothing is left; the reason of the signal; the error of the sink
 */
export function treatRecording(
  reader: EventsReader,
  sink: RecordingSink,
  treatment: Treatment,
  options: CutOptions = {},
): Promise<WriterStatistics> {
  return cutRecording(new TreatedReader(reader, treatment), sink, options);
}
