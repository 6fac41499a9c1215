import type { MasterProcess } from '@ubii/harness';
import {
  lz4Bomb,
  manyMarkers,
  manyMarkersWithoutEnd,
  metadataIndexOf3Gib,
  recordChunkIndexOf3Gib,
} from '@ubii/recording/testing';

import {
  MALFORMED_EVENTS,
  recordingWith,
  readUploadAnswer,
  recordingFile,
  recordingFilePath,
  startRecording,
  type UploadAnswer,
} from '../../fixtures/recordings.ts';
import { pause } from '../../pause.ts';
import type { Random } from '../../random.ts';
import type { Counters } from './counters.ts';

const REPLAY_MS = 300;
const RECORD_MS = 400;
const RECORDS = 200;
/** One upload in so many is hostile. */
const HOSTILE_EVERY = 3;

/** Files that are uploaded, made once. */
export interface UploadedFiles {
  readonly good: readonly Uint8Array[];
  readonly hostile: readonly Uint8Array[];
}

export async function makeUploadedFiles(): Promise<UploadedFiles> {
  const malformed = Object.values(MALFORMED_EVENTS).map((events) => recordingWith({}, events));
  return {
    good: [await recordingFile('/soak/played', RECORDS)],
    hostile: [
      metadataIndexOf3Gib(),
      recordChunkIndexOf3Gib(),
      manyMarkers(),
      manyMarkersWithoutEnd(),
      lz4Bomb(),
      ...(await Promise.all(malformed)),
    ],
  };
}

/** Uploads a file, plays and downloads it, and deletes it. */
export async function uploadAndDelete(
  master: MasterProcess,
  { good, hostile }: UploadedFiles,
  random: Random,
  counters: Counters,
): Promise<void> {
  const isHostile = hostile.length > 0 && random.oneIn(HOSTILE_EVERY);
  const { recording, status, refusal } = await upload(
    master,
    random.pick(isHostile ? hostile : good),
  );
  if (recording === undefined) {
    if (!isHostile || status >= 500) throw new Error(`refused with ${status}: ${refusal}`);
    await deleteRejected(master);
    counters.done('hostile files refused');
    return;
  }
  const { id } = recording;
  await master.call({ topic: '/services/ubii/recording_get', recordingRequest: { id } });
  await fetch(new URL(recordingFilePath(id), master.endpoints.url)).then((one) =>
    one.arrayBuffer(),
  );
  if (!isHostile) await play(master, id, counters);
  await master.call({ topic: '/services/ubii/recording_delete', recordingRequest: { id } });
  counters.done(isHostile ? 'malformed files taken and deleted' : 'files uploaded and deleted');
}

/** Records everything for a moment, with a marker, and deletes it. */
export async function record(master: MasterProcess, counters: Counters): Promise<void> {
  const id = await startRecording(master, 'soak');
  await pause(RECORD_MS);
  await master.call({
    topic: '/services/ubii/recording_mark',
    recordingMarker: { recordingId: id, text: 'soak' },
  });
  const recordingRequest = { id };
  const stopped = await master.call({ topic: '/services/ubii/recording_stop', recordingRequest });
  if (!(stopped.recording!.recordCount > 0)) throw new Error('A recording has no records.');
  await master.call({ topic: '/services/ubii/recording_delete', recordingRequest });
  counters.done('recordings');
}

async function upload(master: MasterProcess, file: Uint8Array): Promise<UploadAnswer> {
  const response = await fetch(new URL('/recordings?name=soak', master.endpoints.url), {
    method: 'POST',
    headers: { 'content-type': 'application/octet-stream' },
    body: Buffer.from(file),
  });
  return readUploadAnswer(response.status, new Uint8Array(await response.arrayBuffer()));
}

async function play(master: MasterProcess, recordingId: string, counters: Counters): Promise<void> {
  const { replay } = await master.call({
    topic: '/services/ubii/replay_start',
    // Several at once play the same topic: only ghosts may.
    replayStartRequest: { recordingId, isGhost: true },
  });
  await pause(REPLAY_MS);
  const replayRequest = { id: replay!.id };
  await master.call({ topic: '/services/ubii/replay_stop', replayRequest });
  counters.done('replays');
}

/** Deletes files that the master keeps with the reason why it does not read them. */
async function deleteRejected(master: MasterProcess): Promise<void> {
  const { recordingList } = await master.call({ topic: '/services/ubii/recording_list' });
  for (const { id, problem } of recordingList!.elements) {
    if (problem === '') continue;
    // Another worker may have deleted it.
    const { error } = await master.ask({
      topic: '/services/ubii/recording_delete',
      recordingRequest: { id },
    });
    if (error !== undefined && error.code !== 'not_found') throw new Error(error.message);
  }
}
