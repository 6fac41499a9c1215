import { FakeClock, settle } from '@ubii/timing/testing';
import fc from 'fast-check';
import { expect, it, vi } from 'vitest';
import { RecordingReader } from '../reading/recording-reader.ts';
import type { RecordedRecord } from '../records/recorded-record.ts';
import { recorded } from '../testing/recorded.ts';
import { SAMPLE_START_NS, sampleRecord } from '../testing/sample-records.ts';
import { Playback, type PlaybackSink, type PlaybackState } from './playback.ts';

const at = (ms: number): bigint => SAMPLE_START_NS + BigInt(Math.round(ms * 1e6));
const msOf = (timeNs: bigint): number => Number(timeNs - SAMPLE_START_NS) / 1e6;

/** `/a` every 100 ms for 2 s, `/b` at 50, 1 050 and 1 950 ms. */
const RECORDS = [
  ...Array.from({ length: 21 }, (_, i) => sampleRecord('/a', i * 100)),
  ...[50, 1_050, 1_950].map((ms) => sampleRecord('/b', ms)),
].sort((a, b) => Number(a.logTimeNs - b.logTimeNs));

async function open(records: readonly RecordedRecord[] = RECORDS) {
  const reader = await RecordingReader.open(await recorded(records));
  const clock = new FakeClock();
  const played: RecordedRecord[] = [];
  const seeks: { ms: number; values: Record<string, number> }[] = [];
  const states: PlaybackState[] = [];
  const errors: unknown[] = [];
  const sink: PlaybackSink = {
    onRecords: (due) => played.push(...due),
    onSeek: (latest, positionNs) => {
      const values = [...latest].map(([topic, { logTimeNs }]) => [topic, msOf(logTimeNs)]);
      seeks.push({ ms: msOf(positionNs), values: Object.fromEntries(values) });
    },
    onState: (state) => states.push(state),
    onError: (error) => errors.push(error),
  };
  const playback = new Playback({ clock, reader, tickMs: 10, sink });
  const settled = async (ms: number): Promise<void> => {
    await settle();
    await clock.advance(ms);
  };
  const position = (): number => msOf(playback.state.positionNs);
  return { clock, errors, played, playback, position, reader, seeks, settled, sink, states };
}

it('begins paused at the start', async () => {
  const { playback, played, position, settled } = await open();
  await settled(1_000);
  expect([playback.state.status, position(), played]).toEqual(['paused', 0, []]);
});

it('plays each record once, at its time, and ends', async () => {
  const { playback, played, position, settled, clock } = await open();
  playback.play();
  await settled(1_000);
  expect(played).toEqual(RECORDS.filter(({ logTimeNs }) => logTimeNs <= at(1_000)));
  expect(position()).toBe(1_000);
  await settled(2_000);
  expect(played).toEqual(RECORDS);
  expect(playback.state.status).toBe('ended');
  expect(clock.timerCount).toBe(0);
});

it.each([
  [0.1, 0.1],
  [0.01, 0.1],
  [2, 2],
  [10, 10],
  [99, 10],
])('with rate %d passes %d times as fast', async (rate, wanted) => {
  const { playback, position, settled } = await open();
  playback.setRate(rate);
  playback.play();
  await settled(100);
  expect(playback.state.rate).toBe(wanted);
  expect(position()).toBeCloseTo(100 * wanted);
});

it('stands while paused and goes on from there', async () => {
  const { playback, played, position, settled } = await open();
  playback.play();
  await settled(500);
  playback.pause();
  await settled(5_000);
  expect(position()).toBe(500);
  playback.play();
  await settled(1_600);
  expect(played).toEqual(RECORDS);
});

it('emits the last value of every topic when it jumps', async () => {
  const { playback, played, seeks, settled } = await open();
  await playback.seek(at(1_060));
  expect(seeks).toEqual([{ ms: 1_060, values: { '/a': 1_000, '/b': 1_050 } }]);
  playback.play();
  await settled(100);
  expect(played).toEqual([sampleRecord('/a', 1_100)]);
});

it('jumps within the recording only', async () => {
  const { playback, position } = await open();
  await playback.seek(at(99_999));
  expect(position()).toBe(2_000);
  await playback.seek(at(-99_999));
  expect(position()).toBe(0);
});

it('keeps only the newest of the jumps that come while one runs', async () => {
  const { playback, seeks } = await open();
  await Promise.all([300, 400, 500, 600].map((ms) => playback.seek(at(ms))));
  expect(seeks.map(({ ms }) => ms)).toEqual([300, 600]);
});

it('steps to the next and the previous record of a topic, and by a time', async () => {
  const { playback, position } = await open();
  const positions = [];
  for (const direction of [1, 1, -1, -1, 1, 1, 1] as const) {
    await playback.stepRecord('/b', direction);
    positions.push(position());
  }
  expect(positions).toEqual([50, 1_050, 50, 50, 1_050, 1_950, 1_950]);
  await playback.stepTime(-100);
  expect(position()).toBe(1_850);
  playback.play();
  await playback.stepTime(33.3);
  expect([playback.state.status, position()]).toEqual(['paused', 1_883.3]);
});

it('steps on by moments with their records, and back with the last values', async () => {
  const { playback, played, position, seeks } = await open([...RECORDS, sampleRecord('/c', 2_000)]);
  await playback.step(3);
  expect(played.map(({ topic }) => topic)).toEqual(['/a', '/b', '/a']);
  expect(position()).toBe(100);
  await playback.step(-2);
  expect(seeks).toEqual([{ ms: 0, values: { '/a': 0 } }]);
  played.length = 0;
  await playback.step(99);
  expect(played.at(-1)?.topic).toBe('/c');
  await playback.step(1);
  expect([position(), played.length]).toEqual([2_000, RECORDS.length]);
});

it('steps no further than its span', async () => {
  const { playback, position } = await open();
  playback.setSpan({ fromNs: at(0), untilNs: at(200) });
  await playback.step(99);
  expect(position()).toBe(200);
});

it('plays a span once and ends there', async () => {
  const { playback, played, position, settled } = await open();
  playback.setSpan({ fromNs: at(500), untilNs: at(700) });
  playback.play();
  await settled(1_000);
  expect(played.map(({ logTimeNs }) => msOf(logTimeNs))).toEqual([600, 700]);
  expect([playback.state.status, position()]).toEqual(['ended', 700]);
});

it('waits while the sink takes nothing, and loses nothing', async () => {
  const { playback, played, position, settled, sink } = await open();
  playback.play();
  await settled(300);
  sink.isReady = () => false;
  await settled(5_000);
  expect([position(), playback.state.isBuffering, played.length]).toEqual([300, true, 5]);
  sink.isReady = () => true;
  await settled(1_700);
  expect(played).toEqual(RECORDS);
});

it('plays a loop again and again', async () => {
  const { playback, played, position, seeks, settled } = await open();
  playback.setLoop({ fromNs: at(500), untilNs: at(700) });
  playback.play();
  await settled(500);
  expect(seeks.map(({ ms }) => ms)).toEqual([500, 500, 500]);
  expect(played.map(({ logTimeNs }) => msOf(logTimeNs))).toEqual([600, 700, 600, 700, 600]);
  expect(position()).toBe(600);
  playback.setLoop(undefined);
  await settled(2_000);
  expect(playback.state.status).toBe('ended');
});

it('starts over when it is played at its end', async () => {
  const { playback, played, seeks, settled } = await open();
  playback.play();
  await settled(2_500);
  played.length = 0;
  playback.play();
  await settled(100);
  expect(seeks).toEqual([{ ms: 0, values: { '/a': 0 } }]);
  expect(played.map(({ topic }) => topic)).toEqual(['/b', '/a']);
});

it('waits while the source is behind, and tells so', async () => {
  const { playback, position, reader, settled, played } = await open();
  const { records } = reader;
  let release = (): void => undefined;
  const gate = new Promise<void>((resolve) => (release = resolve));
  vi.spyOn(reader, 'records').mockImplementation(async function* (query) {
    await gate;
    yield* records.call(reader, query);
  });
  playback.play();
  await settled(300);
  expect([position(), playback.state.isBuffering, played]).toEqual([0, true, []]);
  release();
  await settled(100);
  expect([position(), playback.state.isBuffering]).toEqual([100, false]);
});

it('pauses and tells when the source fails', async () => {
  const { playback, errors, reader, settled } = await open();
  vi.spyOn(reader, 'latestAt').mockRejectedValue(new Error('gone'));
  playback.play();
  await settled(50);
  await playback.seek(at(500));
  expect(errors).toEqual([new Error('gone')]);
  expect(playback.state.status).toBe('paused');
});

it('is silent once closed', async () => {
  const { playback, clock, seeks, states } = await open();
  playback.play();
  const jump = playback.seek(at(500));
  playback.close();
  const known = states.length;
  await jump;
  playback.play();
  await clock.advance(1_000);
  expect([seeks.length, states.length, clock.timerCount]).toEqual([0, known, 0]);
});

it('loses and repeats nothing, however it is paused and however fast it plays', async () => {
  const moves = fc.array(
    fc.oneof(
      fc.record({ rate: fc.double({ min: 0.1, max: 10, noNaN: true }) }),
      fc.record({ ms: fc.nat(300) }),
      fc.constant('pause' as const),
      fc.constant('play' as const),
    ),
    { maxLength: 30 },
  );
  await fc.assert(
    fc.asyncProperty(moves, async (steps) => {
      const { playback, played, settled } = await open();
      for (const step of steps) {
        if (step === 'pause') playback.pause();
        else if (step === 'play' && playback.state.status !== 'ended') playback.play();
        else if (typeof step === 'object' && 'rate' in step) playback.setRate(step.rate);
        else if (typeof step === 'object') await settled(step.ms);
      }
      if (playback.state.status !== 'ended') playback.play();
      await settled(30_000);
      expect(played).toEqual(RECORDS);
    }),
    { numRuns: 30 },
  );
});
