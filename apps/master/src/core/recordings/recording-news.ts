import { RECORDING_STATUS_TOPIC, type FlightRecorderSettings } from '@ubii/proto';
import type { MasterPublisher } from '../info/master-publisher.ts';
import type { RecorderState } from '@ubii/recording/recorder';

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

/** What a recorder says before its first record. */
export function idleState(settings: FlightRecorderSettings): RecorderState {
  const held = { heldMs: 0, heldBytes: 0, topicCount: 0, recordCount: 0, lostCount: 0 };
  const flight = { ...settings, ...held, recordsPerSecond: [] };
  return { running: [], targets: 0, flight, listRevision: 0 };
}
