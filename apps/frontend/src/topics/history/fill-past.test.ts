import { encodeRecord, type DataFormat, type FlightRecord, type TopicRecord } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { fillPast } from './fill-past.ts';
import { PastRecords } from './past-records.ts';
import { TopicHistory } from './topic-history.ts';

const turn = () => Promise.resolve();
const flight = (
  value: number,
  timeMs: number,
  topic = '/a',
  timestampMs?: number,
): FlightRecord => ({
  timeMs,
  record: encodeRecord({ topic, format: 'double', value, timestampMs, clientId: 'ada' }),
});
const live = (value: unknown, timestampMs?: number, format: DataFormat = 'double') =>
  ({ topic: '/a', format, value, timestampMs, clientId: 'ada' }) as TopicRecord;
const valuesOf = (history: TopicHistory) => {
  const line = history.lineOf('')!;
  return Array.from({ length: line.size }, (_, i) => [line.timeAt(i), line.valueAt(i)]);
};

describe('the past of a topic', () => {
  it('[RC-36] is plotted before what came since, which keeps its numbers', async () => {
    const history = new TopicHistory();
    history.add(live(3), 1300);
    history.add(live(4), 1400);
    const plotted = history.points;
    await fillPast(history, [flight(1, 1100), flight(2, 1200), flight(3, 1300)], turn);
    expect(valuesOf(history)).toEqual([
      ...[
        [1100, 1],
        [1200, 2],
      ],
      ...[
        [1300, 3],
        [1400, 4],
      ],
    ]);
    expect(history.points).not.toBe(plotted);
    expect(history.count).toBe(2);
    expect(history.lines().map(({ number }) => number)).toEqual([2, 1, 0, -1]);
    history.add(live(5), 1500);
    expect(history.lineAt(3)).toMatchObject({ numbers: [5] });
  });

  it('ends where new records begin, by the clock of their publisher', async () => {
    const startMs = Date.UTC(2026, 0);
    const history = new TopicHistory();
    history.add(live(4, startMs + 30), startMs + 50);
    const past = [10, 20, 30, 40].map((ms) => {
      const timestampMs = startMs + Math.min(30, ms);
      return flight(ms / 10, startMs + ms + 5, '/a', timestampMs);
    });
    await fillPast(history, past, turn);
    expect(valuesOf(history).map(([, value]) => value)).toEqual([1, 2, 3, 4]);
  });

  it('continues with its own clock: a first record that was there before looks older than it is', async () => {
    const startMs = Date.UTC(2026, 0);
    const history = new TopicHistory();
    history.add(live(3, startMs + 300), startMs - 500);
    history.add(live(4, startMs + 400), startMs + 430);
    const past = [100, 200, 300].map((ms) =>
      flight(ms / 100, startMs + ms + 5, '/a', startMs + ms),
    );
    await fillPast(history, past, turn);
    expect(valuesOf(history).map(([ms]) => Math.round(ms! - startMs))).toEqual([
      105, 205, 305, 405,
    ]);
    expect(history.count).toBe(2);
    history.add(live(5, startMs + 500), startMs + 530);
    expect(Math.round(history.latestLocalMs - startMs)).toBe(505);
  });

  it('is all there is of a topic that is silent', async () => {
    const history = new TopicHistory();
    await fillPast(history, [flight(1, 1100)], turn);
    expect(history.latest?.value).toBe(1);
    await fillPast(new TopicHistory(), [], turn);
  });

  it('leaves pictures as they are, of which only the newest is kept', async () => {
    const history = new TopicHistory();
    const image = { width: 200, height: 200, dataFormat: 0, data: new Uint8Array(40_000) };
    history.add(live(image, undefined, 'image2D'), 1300);
    await fillPast(history, [flight(1, 1100)], turn);
    expect(history.latest?.value).toBe(image);
    expect(history.lines()).toHaveLength(1);
  });

  it('gives the page turns', async () => {
    let turns = 0;
    const past = Array.from({ length: 2000 }, (_, i) => flight(i, i));
    await fillPast(new TopicHistory(), past, () => Promise.resolve(void turns++));
    expect(turns).toBe(8);
  });
});

describe('PastRecords', () => {
  it('asks for all topics of a page at once, and again for those that come later', async () => {
    const asked: string[][] = [];
    const past = new PastRecords((topics) => {
      asked.push([...topics]);
      return Promise.resolve([flight(1, 10), flight(2, 20, '/b'), flight(3, 30, '/c')]);
    });
    const [a, b] = await Promise.all([past.of('/a'), past.of('/b'), past.of('/a')]);
    expect(asked).toEqual([['/a', '/b']]);
    expect([a, b].map((of) => of.map(({ timeMs }) => timeMs))).toEqual([[10], [20]]);
    expect(await past.of('/c')).toHaveLength(1);
    expect(asked).toEqual([['/a', '/b'], ['/c']]);
  });

  it('is empty where it cannot be had, and tries again', async () => {
    let isRefused = true;
    const past = new PastRecords(() =>
      isRefused ? Promise.reject(new Error('no')) : Promise.resolve([flight(1, 10)]),
    );
    expect(await past.of('/a')).toEqual([]);
    isRefused = false;
    expect(await past.of('/a')).toHaveLength(1);
  });
});
