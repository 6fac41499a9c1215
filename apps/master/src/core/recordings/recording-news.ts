import { RECORDING_STATUS_TOPIC } from '@ubii/proto';
import type { MasterPublisher } from '../info/master-publisher.ts';
import type { RecorderState } from '../ports/recorder.ts';

/** Publishes what is recorded now. [RC-8] */
export function publishStatus(
  publisher: MasterPublisher,
  { running, flight, listRevision }: RecorderState,
): void {
  publisher.publish(RECORDING_STATUS_TOPIC, {
    recordingStatus: {
      running: running.map((recording) => ({ ...recording, selection: undefined })),
      flightRecorder: { ...flight, recordsPerSecond: [] },
      listRevision,
    },
  });
}
