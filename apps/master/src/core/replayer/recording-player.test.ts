import { RecordingReader, type RecordedRecord } from '@ubii/recording';
import { recorded, sampleRecord, SAMPLE_START_NS } from '@ubii/recording/testing';
import { FakeClock, settle } from '@ubii/timing/testing';
import { expect, it } from 'vitest';
import type { PlayedBatch, PlayerState } from '../ports/replay-files.ts';
import { RecordingPlayer } from './recording-player.ts';
import { splitIntoFrames } from './recording-player.ts';

const MANY = 20_000;

async function open(records: readonly RecordedRecord[], publish: () => Promise<void>) {
  const clock = new FakeClock();
  const batches: PlayedBatch[] = [];
  const states: PlayerState[] = [];
  const player = new RecordingPlayer({
    clock,
    reader: await RecordingReader.open(await recorded(records)),
    part: {
      topics: [['/a', '/a']],
      clientId: undefined,
      keepsTimestamps: true,
      readAheadBytes: 1e6,
    },
    sink: {
      onBatch: (batch) => {
        batches.push(batch);
        return publish();
      },
      onState: (state) => void states.push(state),
      onLost: () => undefined,
    },
  });
  const count = (): number => batches.reduce((sum, { records: each }) => sum + each, 0);
  const pass = async (ms: number): Promise<void> => {
    for (let passedMs = 0; passedMs < ms; passedMs += 20) {
      await clock.advance(20);
      await settle();
    }
  };
  return { clock, player, batches, states, count, pass };
}

it('[RP-14] waits while batches are not published, and loses nothing', async () => {
  let publishAll = (): void => undefined;
  const published = new Promise<void>((resolve) => (publishAll = resolve));
  const records = Array.from({ length: MANY }, (_, index) => sampleRecord('/a', index / 20));
  const { player, states, count, pass } = await open(records, () => published);
  await player.do({ kind: 'play' });
  await pass(5_000);
  expect(count()).toBeLessThan(MANY / 2);
  expect(states.at(-1)!.status).toBe('playing');
  publishAll();
  await pass(5_000);
  expect([count(), states.at(-1)!.status]).toEqual([MANY, 'ended']);
});

it('[RP-11] resolves a jump when its values are published', async () => {
  let publishAll = (): void => undefined;
  const published = new Promise<void>((resolve) => (publishAll = resolve));
  const { player, count } = await open([sampleRecord('/a', 0)], () => published);
  let isDone = false;
  const done = player.do({ kind: 'seek', positionNs: SAMPLE_START_NS }).then(() => (isDone = true));
  while (count() === 0) await settle();
  await settle();
  expect(isDone).toBe(false);
  publishAll();
  await done;
});

it('[RP-7] tells its position five times a second', async () => {
  const records = [sampleRecord('/a', 0), sampleRecord('/a', 10_000)];
  const { player, states, pass } = await open(records, () => Promise.resolve());
  await player.do({ kind: 'play' });
  states.length = 0;
  await pass(2_000);
  expect(states.length).toBeGreaterThan(7);
  expect(states.length).toBeLessThan(12);
});

it('[RP-6] plays nothing once it is closed', async () => {
  const records = Array.from({ length: 100 }, (_, index) => sampleRecord('/a', index * 10));
  const { clock, player, count, pass } = await open(records, () => Promise.resolve());
  await player.do({ kind: 'play' });
  await pass(100);
  player.close();
  const before = count();
  await pass(1_000);
  expect([count(), clock.timerCount]).toEqual([before, 0]);
});

it('[RP-14] puts records into frames that leave others their turn', () => {
  const of = (length: number, bytes: number) =>
    Array.from({ length }, () => ({ topic: '/a', record: new Uint8Array(bytes) }));
  const sizes = (records: ReturnType<typeof of>) =>
    [...splitIntoFrames(records)].map((frame) => frame.records);
  expect(sizes([])).toEqual([]);
  expect(sizes(of(1_200, 10))).toEqual([500, 500, 200]);
  expect(sizes(of(3, 1_000_000))).toEqual([2, 1]);
});
