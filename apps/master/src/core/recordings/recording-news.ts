import { RECORDING_STATUS_TOPIC, type FlightRecorderSettings, type Recording } from '@ubii/proto';
import type { MasterPublisher } from '../info/master-publisher.ts';
import type { RecorderState } from '@ubii/recording/recorder';
import { publicName } from './public-name.ts';

/** Publishes what is recorded now. [RC-8] */
export function publishStatus(
  publisher: MasterPublisher,
  { running, flight, listRevision }: RecorderState,
): void {
  publisher.publish(RECORDING_STATUS_TOPIC, {
    recordingStatus: {
      running: running.map(publicPart),
      flightRecorder: { ...flight, recordsPerSecond: [] },
      listRevision,
    },
  });
}

/** Public facts of a recording: that it runs, and its owner, but nothing of a participant. [RC-8] [ST-54] */
function publicPart(recording: Recording): Recording {
  const name = publicName(recording);
  return { ...recording, name, notes: '', study: undefined, selection: undefined };
}

/** What a recorder says before its first record. */
export function idleState(settings: FlightRecorderSettings): RecorderState {
  const held = { heldMs: 0, heldBytes: 0, topicCount: 0, recordCount: 0, lostCount: 0 };
  const flight = { ...settings, ...held, recordsPerSecond: [] };
  return { running: [], targets: 0, flight, listRevision: 0 };
}
