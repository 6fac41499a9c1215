import { encodeRecord, type RecordInit } from '@ubii/proto';
import { RecordingReader, RecordingWriter } from '@ubii/recording';
import { MemoryFile, SAMPLE_HEADER } from '@ubii/recording/testing';
import { FakeClock } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import { decodeRecorded } from './decode-recorded.ts';
import { ReadTurns } from './read-turns.ts';
import { RecordingDesk } from './recording-desk.ts';
import type { RecordingPage } from './recording-messages.ts';

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

type Shown = { [Name in keyof RecordingPage]: Parameters<RecordingPage[Name]>[] };

/** A desk, and what it showed the page. */
async function setUp() {
  const shown: Shown = {
    showOpened: [],
    showFailure: [],
    showActivity: [],
    showSurvey: [],
    showClocks: [],
    showTile: [],
    showPlayer: [],
    showValues: [],
    showSessions: [],
  };
  const order: string[] = [];
  const page = new Proxy({} as RecordingPage, {
    get:
      (_target, name: keyof RecordingPage) =>
      (...args: never[]) => {
        order.push(name);
        (shown[name] as unknown[]).push(args);
      },
  });
  const desk = new RecordingDesk(await aRecording(), new FakeClock(), turns(), page);
  const last = <Name extends keyof RecordingPage>(name: Name) =>
    shown[name].at(-1) as Parameters<RecordingPage[Name]>;
  return { desk, shown, order, last };
}
async function begun() {
  const made = await setUp();
  await made.desk.begin();
  return made;
}

describe('the worker that reads a recording', () => {
  it('says how many records came when before it has read any', async () => {
    const { order, last } = await begun();
    const [{ all, topics }] = last('showActivity');
    expect([...topics.keys()]).toEqual(['/a', '/b']);
    expect(all.reduce((sum, count) => sum + count, 0)).toBeCloseTo(222, 1);
    expect(order.indexOf('showActivity')).toBeLessThan(order.indexOf('showSurvey'));
  });

  it('says what is in it, in milliseconds since its beginning', async () => {
    const { last } = await begun();
    expect(last('showOpened')[0]).toMatchObject({
      startMs: START_MS,
      durationMs: 2000,
      markers: [{ id: 'm', timeMs: 500, text: 'here', author: 'Jo' }],
      gaps: [{ fromMs: 700, untilMs: 800, records: 3 }],
      isDamaged: false,
    });
    expect(last('showClocks')[0]).toBe(0.8);
  });

  it('surveys all of it', async () => {
    const { last } = await begun();
    const [{ tracks, isWhole }] = last('showSurvey');
    expect(isWhole).toBe(true);
    const text = tracks.find(({ topic }) => topic === '/b')!;
    expect(text.runs.map(({ label, fromMs, untilMs }) => [label, fromMs, untilMs])).toEqual([
      ['rest', 0, 1000],
      ['swipe', 1000, 2000],
    ]);
  });

  it('reads the tiles that are asked for', async () => {
    const { desk, shown } = await begun();
    const request = { viewer: 'timeline', topics: ['/a'], level: 0, first: 1, last: 1 } as const;
    await desk.readTiles(request);
    const [topic, level, index, tile] = shown.showTile[0]!;
    expect([topic, level, index, tile.isWhole]).toEqual(['/a', 0, 1, true]);
    const low = [...tile.lines[0]!.low];
    expect(low.filter((value) => !Number.isNaN(value)).slice(0, 3)).toEqual([520, 530, 540]);
  });

  it('tells the last value of every topic where the playhead is moved to', async () => {
    const { desk, last } = await begun();
    await desk.seek(1005);
    const [values, isAll] = last('showValues');
    expect(isAll).toBe(true);
    const shownValues = values.map(({ topic, timeMs, record }) => [
      topic,
      timeMs,
      decodeRecorded(topic, record)?.value,
    ]);
    expect(new Map(shownValues.map(([topic, ...rest]) => [topic, rest]))).toEqual(
      new Map([
        ['/a', [1000, 1000]],
        ['/b', [1000, 'swipe']],
      ]),
    );
    expect(last('showPlayer')[0].timeMs).toBe(1005);
  });

  it('steps from record to record', async () => {
    const { desk, last } = await begun();
    await desk.seek(1005);
    await desk.stepRecord('/a', 1);
    expect(last('showPlayer')[0].timeMs).toBe(1010);
    await desk.stepRecord('/b', -1);
    expect(last('showPlayer')[0].timeMs).toBe(1000);
  });

  it('goes on where it was when the file is opened again', async () => {
    const { desk } = await begun();
    await desk.seek(500);
    await desk.setRate(2);
    await desk.setLoop({ fromMs: 100, untilMs: 900 });
    const { desk: next, shown, last } = await setUp();
    await next.resume(desk.state);
    expect(last('showPlayer')[0]).toMatchObject({
      timeMs: 500,
      rate: 2,
      loop: { fromMs: 100, untilMs: 900 },
    });
    expect(shown.showSurvey).toEqual([]);
  });

  it('tells the sessions as they were', async () => {
    const { last } = await begun();
    expect(last('showSessions')[0]).toMatchObject([{ id: 's', name: 'Study', state: 'running' }]);
  });
});
