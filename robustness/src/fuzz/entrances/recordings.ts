import {
  RecordingError,
  RecordingReader,
  repairRecording,
  type RecordingSource,
} from '@ubii/recording';
import {
  attachmentIndexOf3Gib,
  lz4Bomb,
  manyMarkers,
  manyMarkersWithoutEnd,
  markerChunkIndexOf3Gib,
  MemoryFile,
  metadataIndexOf3Gib,
  plainRecording,
  recorded,
  recordChunkIndexOf3Gib,
  recordedDevice,
  sampleRecord,
} from '@ubii/recording/testing';

import {
  MALFORMED_EVENTS,
  recordingWith,
  readUploadAnswer,
  type UploadAnswer,
} from '../../fixtures/recordings.ts';
import { pause } from '../../pause.ts';
import type { Entrance, FuzzTarget } from '../entrance.ts';
import { mutateBytes } from '../mutate-bytes.ts';
import { mutateMcap } from '../mutate-mcap.ts';

const GATE_CASES = 60;
/** The master judges each upload in a process of its own. */
const GATE_UPLOADS = 8;

/** Beyond the limit of what a chunk may unpack to, and quick to judge. */
const LARGE_CHUNK_BYTES = 80_000_000;
/** Records that are read of one file. */
const MAX_RECORDS = 2_000;
const MAX_TRIES = 20;
const RETRY_MS = 50;
/** Statuses with which an upload may be turned away. */
const TURNED_AWAY = new Set([400, 403, 408, 413, 429, 507]);

const DEVICE = recordedDevice('phone', 'ada', [{ topic: '/a' }]);
const GOOD = [
  await plainRecording(),
  (
    await recorded(
      Array.from({ length: 20 }, (_, index) => sampleRecord(index % 2 ? '/a' : '/b', index * 10)),
      [{ kind: 'device', timeNs: sampleRecord('/a', 0).logTimeNs, value: DEVICE }],
    )
  ).bytes,
  ...(await Promise.all(
    Object.values(MALFORMED_EVENTS).map((events) => recordingWith({}, events)),
  )),
  await recordingWith({ name: 'n'.repeat(5_000), notes: 'n'.repeat(5_000) }),
];
const LIES = [
  attachmentIndexOf3Gib(),
  markerChunkIndexOf3Gib(),
  metadataIndexOf3Gib(),
  recordChunkIndexOf3Gib(),
];

/** Files that a participant uploads, and what pages then do with them. */
export const uploads: Entrance = {
  name: 'uploads',
  about: 'uploaded MCAP files: judging, listing, marking, changing, playing, deleting',
  kind: 'running',
  gateCases: GATE_UPLOADS,
  seeds: () => [
    ...GOOD,
    ...LIES,
    manyMarkers(20_000),
    manyMarkersWithoutEnd(20_000),
    lz4Bomb(LARGE_CHUNK_BYTES),
  ],
  mutate: (random, seed, other) =>
    random.oneIn(6) ? mutateBytes(random, seed, other) : mutateMcap(random, seed, other),
  async deliver(input, { master }) {
    const { status, recording, refusal } = await upload(input, master);
    if (recording === undefined && !TURNED_AWAY.has(status)) {
      throw new Error(`The upload was answered with ${status}: ${refusal.slice(0, 400)}`);
    }
    if (recording !== undefined) await use(master, recording.id);
  },
};

/** Readers of recordings in this process, as pages, programs and the judge of uploads use them. */
export const recordingFiles: Entrance = {
  name: 'recording-files',
  about: 'readers and repair of MCAP files, in this process',
  kind: 'parser',
  gateCases: GATE_CASES,
  seeds: () => [...GOOD, ...LIES, manyMarkers(500), manyMarkersWithoutEnd(500), lz4Bomb(1_000_000)],
  mutate: (random, seed, other) =>
    random.oneIn(6) ? mutateBytes(random, seed, other) : mutateMcap(random, seed, other),
  async deliver(input) {
    await allowing(() => readAll(new MemoryFile(input)));
    await allowing(async () => {
      const file = new MemoryFile(new Uint8Array(input));
      await repairRecording(file);
      await RecordingReader.open(file);
    });
  },
};

/** Uploads, later when others upload at the same time: their number is limited. */
async function upload(
  input: Uint8Array,
  { endpoints }: FuzzTarget['master'],
): Promise<UploadAnswer> {
  for (let left = MAX_TRIES; ; left--) {
    const response = await fetch(new URL('/recordings?name=fuzz', endpoints.url), {
      method: 'POST',
      headers: { 'content-type': 'application/octet-stream' },
      body: Buffer.from(input),
    });
    const answer = readUploadAnswer(response.status, new Uint8Array(await response.arrayBuffer()));
    if (answer.status !== 429 || left === 0) return answer;
    await pause(RETRY_MS);
  }
}

async function readAll(source: RecordingSource): Promise<void> {
  const reader = await RecordingReader.open(source);
  const { startNs, endNs } = reader.summary;
  reader.activity(20);
  for (const part of reader.foreignParts()) {
    await allowing(async () => {
      for await (const piece of part.pieces()) void piece;
    });
  }
  await allowing(() => reader.events());
  await allowing(() => reader.latestAt((startNs + endNs) / 2n));
  for (const isReverse of [false, true]) {
    await allowing(async () => {
      let count = 0;
      for await (const record of reader.records({ isReverse })) {
        if (record.record.length >= 0 && ++count >= MAX_RECORDS) return;
      }
    });
  }
}

async function use(master: FuzzTarget['master'], id: string): Promise<void> {
  const recordingRequest = { id };
  const ask = async (request: Parameters<typeof master.ask>[0]) => {
    const reply = await master.ask(request);
    if (reply.error?.code === 'internal' || reply.error?.code === 'unavailable') {
      throw new Error(`${request.topic} was answered with: ${reply.error.message}`);
    }
    return reply;
  };
  await ask({ topic: '/services/ubii/recording_get', recordingRequest });
  await ask({
    topic: '/services/ubii/recording_mark',
    recordingMarker: { recordingId: id, text: 'a' },
  });
  await ask({
    topic: '/services/ubii/recording_change',
    recordingChangeRequest: { id, name: 'changed', notes: '' },
  });
  // Their number is limited: one that cannot be started is no fault.
  const { replay } = await ask({
    topic: '/services/ubii/replay_start',
    replayStartRequest: { recordingId: id, rate: 10, isGhost: true },
  });
  if (replay !== undefined) {
    await ask({ topic: '/services/ubii/replay_stop', replayRequest: { id: replay.id } });
  }
  await ask({ topic: '/services/ubii/recording_list' });
  await ask({ topic: '/services/ubii/recording_delete', recordingRequest });
}

/** @throws what is no documented error */
async function allowing(read: () => Promise<unknown>): Promise<void> {
  try {
    await read();
  } catch (error) {
    if (!(error instanceof RecordingError)) throw error;
  }
}
