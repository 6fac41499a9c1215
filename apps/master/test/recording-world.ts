import type { Init, RecordingSelection } from '@ubii/proto';
import type { TestMaster } from '../src/testing/index.ts';
import { readRecording } from '../src/testing/read-recording.ts';

/** Topics of our services begin so. */
export const SERVICES = '/services/ubii/';

/** Starts a recording. Returns its id. */
export async function start(
  master: TestMaster,
  selection: Init<RecordingSelection> = {},
  name = 'Lesson',
): Promise<string> {
  const { recording, error } = await master.call({
    topic: `${SERVICES}recording_start`,
    recordingStartRequest: { name, selection },
  });
  if (recording === undefined) throw new Error(error?.message);
  return recording.id;
}

/** Lets what was published arrive, and stops the recording. */
export async function stop(master: TestMaster, id: string) {
  await master.pass(100);
  const request = { topic: `${SERVICES}recording_stop`, recordingRequest: { id } };
  return (await master.call(request)).recording!;
}

/** What a recording holds, as topics with values. */
export async function contentOf(master: TestMaster, id: string) {
  return readRecording(await master.recordings.open(id));
}
