import { rmSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { temporaryFolder } from '@ubii/program/testing';
import { decodeTopicData } from '@ubii/proto';
import { RecordingWriter } from '@ubii/recording';
import { DiskFile } from '@ubii/recording/node';
import { SAMPLE_HEADER, sampleRecord, SAMPLE_START_NS } from '@ubii/recording/testing';
import { SystemClock } from '@ubii/timing/system';
import { build } from 'esbuild';
import { afterAll, beforeAll, describe, expect, it, onTestFinished } from 'vitest';

import { recordingPath } from '@ubii/recording/node';
import { WorkerReplayFiles } from '../../src/adapters/recording/worker-replay-files.ts';
import type { PlayedBatch, PlayerState } from '../../src/core/ports/index.ts';
import { RecordingLog } from '../../src/testing/index.ts';

const built = temporaryFolder(afterAll);
const RECORDS = 2_000;
let workerFile: URL;

beforeAll(async () => {
  const outfile = join(built, 'replay-worker.mjs');
  const source = new URL('../../src/adapters/recording/replay-worker.ts', import.meta.url);
  await build({
    entryPoints: [fileURLToPath(source)],
    outfile,
    bundle: true,
    platform: 'node',
    format: 'esm',
    logLevel: 'warning',
    banner: {
      js: "import { createRequire } from 'node:module'; const require = createRequire(import.meta.url);",
    },
  });
  workerFile = pathToFileURL(outfile);
}, 60_000);

async function folderWithRecording(): Promise<string> {
  const folder = temporaryFolder();
  const file = await DiskFile.create(recordingPath(folder, 'one'));
  const writer = await RecordingWriter.create(file, SAMPLE_HEADER);
  for (let index = 0; index < RECORDS; index++) {
    await writer.addRecord(sampleRecord(`/t/${index % 10}`, index / 10, index));
  }
  await writer.end();
  await file.close();
  return folder;
}

function openFiles(folder: string, file = workerFile) {
  const log = new RecordingLog();
  const files = new WorkerReplayFiles({ folder, clock: new SystemClock(), log, workerFile: file });
  onTestFinished(() => files.close());
  return { files, log };
}

const PART = {
  topics: Array.from({ length: 10 }, (_, index) => [`/t/${index}`, `/played/${index}`] as const),
  clientId: undefined,
  keepsTimestamps: true,
  readAheadBytes: 1e6,
};

function sink() {
  const values: unknown[] = [];
  const states: PlayerState[] = [];
  const lost: string[] = [];
  return {
    values,
    states,
    lost,
    onBatch({ frame }: PlayedBatch): Promise<void> {
      values.push(...decodeTopicData(frame).records.map(({ value }) => value));
      return Promise.resolve();
    },
    onState: (state: PlayerState) => void states.push(state),
    onLost: (reason: string) => void lost.push(reason),
  };
}

describe('WorkerReplayFiles', () => {
  it('[RP-15] plays a file on a thread, each record once', async () => {
    const { files } = openFiles(await folderWithRecording());
    const file = await files.open('one');
    expect(file.facts).toMatchObject({ startNs: SAMPLE_START_NS });
    expect(file.facts.topics.length).toBe(10);
    const played = sink();
    const player = file.play(PART, played);
    await player.do({ kind: 'seek', positionNs: file.facts.startNs });
    await player.do({ kind: 'rate', rate: 10 });
    await player.do({ kind: 'play' });
    await expect.poll(() => played.states.at(-1)?.status).toBe('ended');
    await expect.poll(() => played.values.length).toBe(RECORDS);
    expect(played.values).toEqual(Array.from({ length: RECORDS }, (_, index) => index));
    await file.close();
  });

  it('[RP-1] refuses what is not there', async () => {
    const { files } = openFiles(temporaryFolder());
    await expect(files.open('none')).rejects.toMatchObject({ code: 'failed_precondition' });
  });

  it('[RP-15] ends its players when the thread cannot be had, and starts another', async () => {
    const { files, log } = openFiles(temporaryFolder(), new URL('file:///not/there.mjs'));
    await expect(files.open('one')).rejects.toMatchObject({ code: 'unavailable' });
    expect(log.lines.at(-1)).toMatchObject({ level: 'error' });
  });

  it('[RP-15] is closed with its players', async () => {
    const folder = await folderWithRecording();
    const { files } = openFiles(folder);
    const file = await files.open('one');
    const played = sink();
    const player = file.play(PART, played);
    await player.do({ kind: 'play' });
    await file.close();
    const { length } = played.values;
    rmSync(folder, { recursive: true });
    await expect(files.open('one')).rejects.toMatchObject({ code: 'failed_precondition' });
    expect(played.values.length).toBe(length);
  });
});
