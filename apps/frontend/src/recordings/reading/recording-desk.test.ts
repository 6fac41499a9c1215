import { encodeRecord, type RecordInit } from '@ubii/proto';
import { RecordingReader, RecordingWriter } from '@ubii/recording';
import { MemoryFile, SAMPLE_HEADER } from '@ubii/recording/testing';
import { FakeClock } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import { decodeRecorded } from './decode-recorded.ts';
import { ReadTurns } from './read-turns.ts';
import { RecordingDesk } from './recording-desk.ts';
import type { RecordingReport } from './recording-messages.ts';

const START_MS = 1_750_000_000_000;
const toNs = (ms: number): bigint => BigInt(START_MS + ms) * 1_000_000n;

/** A recording of 2 s: a number every 10 ms, a text that changes after 1 s, a marker, a gap, and a session. */
async function aRecording(): Promise<RecordingReader> {
  const file = new MemoryFile();
  const writer = await RecordingWriter.create(file, SAMPLE_HEADER);
  const put = (ms: number, init: RecordInit): Promise<void> | undefined => {
    const { topic } = init;
    const times = { logTimeNs: toNs(ms), publishTimeNs: toNs(ms) };
    return writer.addRecord({ topic, clientId: 'mara', record: encodeRecord(init), ...times });
  };
  const session = { id: 's', name: 'Study', state: 'running', session: '{}' };
  writer.addEvent({
    kind: 'client',
    timeNs: toNs(0),
    value: { id: 'mara', name: 'Mara', tags: [], state: 'active' },
  });
  writer.addEvent({ kind: 'session', timeNs: toNs(0), value: session });
  writer.addEvent({
    kind: 'clock',
    timeNs: toNs(0),
    value: { clientId: 'mara', offsetMs: 1, errorMs: 0.8, driftPpm: 0 },
  });
  for (let ms = 0; ms <= 2000; ms += 10) {
    await put(ms, { topic: '/a', format: 'double', value: ms });
    if (ms % 100 === 0)
      await put(ms, { topic: '/b', format: 'string', value: ms < 1000 ? 'rest' : 'swipe' });
  }
  const marker = {
    id: 'm',
    timeMs: START_MS + 500,
    text: 'here',
    author: 'Jo',
    authorId: '',
    kind: 'key',
  };
  writer.addEvent({ kind: 'marker', timeNs: toNs(500), value: marker });
  const gap = { fromMs: START_MS + 700, untilMs: START_MS + 800, records: 3, reason: 'slow' };
  writer.addEvent({ kind: 'gap', timeNs: toNs(800), value: gap });
  await writer.end();
  return RecordingReader.open(file);
}

const turns = (): ReadTurns =>
  new ReadTurns({
    nowMs: () => 0,
    pause: () => Promise.resolve(),
    wait: () => Promise.resolve(),
  });

async function setUp() {
  const reports: RecordingReport[] = [];
  const desk = new RecordingDesk(await aRecording(), new FakeClock(), turns(), (report) =>
    reports.push(report),
  );
  await desk.begin();
  const last = <K extends RecordingReport['kind']>(kind: K) =>
    reports.findLast((report) => report.kind === kind) as RecordingReport & { kind: K };
  return { desk, reports, last };
}

describe('the worker that reads a recording', () => {
  it('says how many records came when before it has read any', async () => {
    const { reports, last } = await setUp();
    const { all, topics } = last('activity').activity;
    expect([...topics.keys()]).toEqual(['/a', '/b']);
    expect(all.reduce((sum, count) => sum + count, 0)).toBeCloseTo(222, 1);
    const kinds = reports.map(({ kind }) => kind);
    expect(kinds.indexOf('activity')).toBeLessThan(kinds.indexOf('survey'));
  });

  it('says what is in it, in milliseconds since its beginning', async () => {
    const { last } = await setUp();
    expect(last('opened').recording).toMatchObject({
      startMs: START_MS,
      durationMs: 2000,
      markers: [{ id: 'm', timeMs: 500, text: 'here', author: 'Jo' }],
      gaps: [{ fromMs: 700, untilMs: 800, records: 3 }],
      isDamaged: false,
    });
    expect(last('clocks').errorMs).toBe(0.8);
  });

  it('surveys all of it', async () => {
    const { last } = await setUp();
    const { tracks, isWhole } = last('survey').survey;
    expect(isWhole).toBe(true);
    const text = tracks.find(({ topic }) => topic === '/b')!;
    expect(text.runs.map(({ label, fromMs, untilMs }) => [label, fromMs, untilMs])).toEqual([
      ['rest', 0, 1000],
      ['swipe', 1000, 2000],
    ]);
  });

  it('reads the tiles that are asked for', async () => {
    const { desk, reports } = await setUp();
    const request = { viewer: 'timeline', topics: ['/a'], level: 0, first: 1, last: 1 } as const;
    await desk.handle({ kind: 'tiles', request });
    const [tile] = reports.filter((report) => report.kind === 'tile');
    expect(tile).toMatchObject({ topic: '/a', level: 0, index: 1, tile: { isWhole: true } });
    const low = [...tile!.tile.lines[0]!.low];
    expect(low.filter((value) => !Number.isNaN(value)).slice(0, 3)).toEqual([520, 530, 540]);
  });

  it('tells the last value of every topic where the playhead is moved to', async () => {
    const { desk, last } = await setUp();
    await desk.handle({ kind: 'seek', timeMs: 1005 });
    const { values, isAll } = last('values');
    expect(isAll).toBe(true);
    const told = values.map(({ topic, timeMs, record }) => [
      topic,
      timeMs,
      decodeRecorded(topic, record)?.value,
    ]);
    expect(new Map(told.map(([topic, ...rest]) => [topic, rest]))).toEqual(
      new Map([
        ['/a', [1000, 1000]],
        ['/b', [1000, 'swipe']],
      ]),
    );
    expect(last('player').player.timeMs).toBe(1005);
  });

  it('steps from record to record', async () => {
    const { desk, last } = await setUp();
    await desk.handle({ kind: 'seek', timeMs: 1005 });
    await desk.handle({ kind: 'stepRecord', topic: '/a', direction: 1 });
    expect(last('player').player.timeMs).toBe(1010);
    await desk.handle({ kind: 'stepRecord', topic: '/b', direction: -1 });
    expect(last('player').player.timeMs).toBe(1000);
  });

  it('goes on where it was when the file is opened again', async () => {
    const { desk } = await setUp();
    await desk.handle({ kind: 'seek', timeMs: 500 });
    await desk.handle({ kind: 'rate', rate: 2 });
    await desk.handle({ kind: 'loop', loop: { fromMs: 100, untilMs: 900 } });
    const reports: RecordingReport[] = [];
    const next = new RecordingDesk(await aRecording(), new FakeClock(), turns(), (report) =>
      reports.push(report),
    );
    await next.resume(desk.state);
    const told = reports.findLast((report) => report.kind === 'player');
    expect(told?.player).toMatchObject({
      timeMs: 500,
      rate: 2,
      loop: { fromMs: 100, untilMs: 900 },
    });
    expect(reports.filter(({ kind }) => kind === 'survey')).toEqual([]);
  });

  it('tells the sessions as they were', async () => {
    const { last } = await setUp();
    expect(last('sessions').sessions).toMatchObject([{ id: 's', name: 'Study', state: 'running' }]);
  });
});
