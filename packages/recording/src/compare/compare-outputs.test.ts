import { encodeRecord } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { RecordingReader } from '../reading/recording-reader.ts';
import type { RecordedRecord } from '../records/recorded-record.ts';
import { recorded, SAMPLE_START_NS, sampleRecord } from '../testing/index.ts';
import { compareOutputs, type CompareOptions } from './index.ts';

const readerOf = async (records: readonly RecordedRecord[]) =>
  RecordingReader.open(await recorded(records));

/** Numbers of a topic, as `[time in ms, value]`. */
const numbers = (topic: string, values: readonly (readonly [number, number])[]) =>
  values.map(([atMs, value]) => sampleRecord(topic, atMs, value));
const INPUTS = [0, 10, 20, 30, 40].map((atMs) => [atMs, atMs] as const);
/** The run began 5 s later and waited 100 ms before its third input. */
const toRun = (atMs: number): number => 5000 + atMs + (atMs >= 20 ? 100 : 0);
const byTime = (records: readonly RecordedRecord[]) =>
  [...records].sort((a, b) => Number(a.logTimeNs - b.logTimeNs));

type Values = readonly (readonly [number, number])[];
/** Compares a recording and a run of its inputs; both outputs are given in times of the recording. */
async function compare(before: Values, after: Values, options: Partial<CompareOptions> = {}) {
  const recordedReader = await readerOf(
    byTime([...numbers('/in', INPUTS), ...numbers('/out', before)]),
  );
  const rerunReader = await readerOf(
    byTime([
      ...numbers(
        '/run/in',
        INPUTS.map(([atMs, value]) => [toRun(atMs), value] as const),
      ),
      ...numbers(
        '/run/out',
        after.map(([atMs, value]) => [toRun(atMs), value] as const),
      ),
    ]),
  );
  const [comparison] = await compareOutputs(recordedReader, rerunReader, {
    topics: ['/out'],
    mapTopic: (topic) => `/run${topic}`,
    inputs: ['/in'],
    mapInput: (topic) => `/run${topic}`,
    toleranceMs: 4,
    relativeTolerance: 0.001,
    ...options,
  });
  return comparison!;
}
const countsOf = ({ same, different, missing, additional }: Awaited<ReturnType<typeof compare>>) =>
  ({ same, different, missing, additional }) as const;
const atMs = (timeNs: bigint): number => Number(timeNs - SAMPLE_START_NS) / 1e6;

const FIVE: Values = [
  [1, 1],
  [11, 2],
  [21, 3],
  [31, 4],
  [41, 5],
];
const without = (place: number): Values => FIVE.filter((_, index) => index !== place);

describe('compareOutputs', () => {
  it('finds the same outputs, however late the run played the inputs', async () => {
    expect(countsOf(await compare(FIVE, FIVE))).toEqual({
      same: 5,
      different: 0,
      missing: 0,
      additional: 0,
    });
  });

  it('reports another value with both values and the moment of the recording', async () => {
    const after = FIVE.map(([at, value]) => [at, value === 4 ? 7 : value] as const);
    const comparison = await compare(FIVE, after);
    expect(countsOf(comparison)).toEqual({ same: 4, different: 1, missing: 0, additional: 0 });
    const [difference] = comparison.differences;
    expect(difference).toMatchObject({ kind: 'different', path: '' });
    expect(atMs(difference!.timeNs)).toBe(31);
    expect([difference!.recorded?.value, difference!.rerun?.value]).toEqual([4, 7]);
  });

  it('reports missing and additional outputs, and continues with those that follow', async () => {
    const options = { toleranceMs: 50 };
    const missing = await compare(FIVE, without(1), options);
    expect(countsOf(missing)).toEqual({ same: 4, different: 0, missing: 1, additional: 0 });
    expect(missing.differences[0]).toMatchObject({ kind: 'missing', rerun: undefined });
    const additional = await compare(without(3), FIVE, options);
    expect(countsOf(additional)).toEqual({ same: 4, different: 0, missing: 0, additional: 1 });
    expect(atMs(additional.differences[0]!.timeNs)).toBe(31);
  });

  it('takes a change that a module samples one round later for the same', async () => {
    const before = [1, 1, 2, 2, 3].map((value, place) => [1 + 10 * place, value] as const);
    const after = [1, 1, 1, 2, 3].map((value, place) => [1 + 10 * place, value] as const);
    const longer = [...after.slice(0, 4), [41, 2], [45, 3]] as const;
    for (const values of [after, longer]) {
      const comparison = await compare(before, values, { toleranceMs: 12 });
      expect(comparison.differences).toEqual([]);
    }
    // Two rounds later is another result.
    const late = [1, 1, 1, 1, 1].map((value, place) => [1 + 10 * place, value] as const);
    expect((await compare(before, late, { toleranceMs: 12 })).different).toBeGreaterThan(0);
  });

  it('takes a change that a module samples some rounds later for the same, within the tolerance', async () => {
    const before = [1, 1, 1, 2, 2, 2, 2].map((value, place) => [1 + place, value] as const);
    const after = [1, 1, 1, 1, 1, 2, 2].map((value, place) => [1 + place, value] as const);
    expect((await compare(before, after, { toleranceMs: 3 })).differences).toEqual([]);
    expect((await compare(before, after, { toleranceMs: 1 })).differences).not.toEqual([]);
  });

  it('leaves out what the run wrote after the end of the recording', async () => {
    const comparison = await compare(FIVE, [...FIVE, [60, 6], [80, 7]]);
    expect(countsOf(comparison)).toEqual({ same: 5, different: 0, missing: 0, additional: 0 });
  });

  it('pairs outputs that all differ by their times', async () => {
    const after = without(2).map(([at, value]) => [at, value + 100] as const);
    const comparison = await compare(FIVE, after, { toleranceMs: 8 });
    expect(countsOf(comparison)).toEqual({ same: 0, different: 4, missing: 1, additional: 0 });
  });

  it('does not pair equal values that are further apart than the tolerance', async () => {
    const comparison = await compare([[1, 1]], [[9, 1]]);
    expect(countsOf(comparison)).toEqual({ same: 0, different: 0, missing: 1, additional: 1 });
  });

  it('takes numbers within the relative tolerance for the same', async () => {
    expect((await compare([[1, 1000]], [[1, 1000.9]])).same).toBe(1);
    expect((await compare([[1, 1000]], [[1, 1001.1]])).different).toBe(1);
    expect((await compare([[1, Infinity]], [[1, 1]])).different).toBe(1);
    expect((await compare([[1, NaN]], [[1, NaN]])).same).toBe(1);
  });

  it('lists no more differences of each kind than asked for, and counts all of them', async () => {
    const after = FIVE.map(([at, value]) => [at, value + 100] as const);
    const comparison = await compare(FIVE, after, { maxDifferences: () => 2 });
    expect(comparison.different).toBe(5);
    expect(comparison.differences).toHaveLength(2);
    // Those of one kind do not hide those of another.
    const both = await compare(FIVE, [[41, 105]], { maxDifferences: () => 1 });
    expect(countsOf(both)).toEqual({ same: 0, different: 1, missing: 4, additional: 0 });
    expect(both.differences.map(({ kind }) => kind)).toEqual(['missing', 'different']);
  });

  it('compares a span that begins with the last values before it', async () => {
    const fromNs = SAMPLE_START_NS + 15_000_000n;
    const span = { fromNs, untilNs: SAMPLE_START_NS + 35_000_000n };
    const recordedReader = await readerOf(
      byTime([...numbers('/in', INPUTS), ...numbers('/out', FIVE)]),
    );
    // The value of 10 ms is played at the start of the span.
    const rerunReader = await readerOf(
      byTime([
        ...numbers('/run/in', [
          [900, 10],
          [905, 20],
          [915, 30],
        ]),
        ...numbers('/run/out', [
          [901, 2],
          [906, 3],
          [916, 4],
        ]),
      ]),
    );
    const [comparison] = await compareOutputs(recordedReader, rerunReader, {
      topics: ['/out'],
      mapTopic: (topic) => `/run${topic}`,
      inputs: ['/in'],
      mapInput: (topic) => `/run${topic}`,
      span,
      toleranceMs: 4,
      relativeTolerance: 0,
    });
    // The output of the first value was recorded before the span.
    expect(countsOf(comparison!)).toEqual({ same: 2, different: 0, missing: 0, additional: 1 });
  });

  it('names the member that differs, and compares pictures by their bytes', async () => {
    const of = (topic: string, x: number, data: readonly number[]): RecordedRecord[] => [
      {
        ...sampleRecord(topic, 0),
        record: encodeRecord({
          topic,
          format: 'pose3D',
          value: { position: { x, y: 2, z: 3 } },
        }),
      },
      {
        ...sampleRecord(`${topic}/image`, 1),
        record: encodeRecord({
          topic: `${topic}/image`,
          format: 'image2D',
          value: { width: 2, height: 1, data: Uint8Array.from(data) },
        }),
      },
    ];
    const options = {
      topics: ['/out', '/out/image'],
      mapTopic: (topic: string) => topic,
      inputs: [],
      mapInput: (topic: string) => topic,
      toleranceMs: 5,
      relativeTolerance: 0,
    };
    const first = await readerOf(of('/out', 1, [1, 2]));
    const [pose, image] = await compareOutputs(
      first,
      await readerOf(of('/out', 1.5, [1, 3])),
      options,
    );
    expect(pose!.differences[0]!.path).toBe('position.x');
    expect(image!.differences[0]!.path).toBe('data');
    const same = await compareOutputs(first, await readerOf(of('/out', 1, [1, 2])), options);
    expect(same.map((one) => one.same)).toEqual([1, 1]);
  });

  it('ends with the reason when it is aborted', async () => {
    const signal = AbortSignal.abort(new Error('Cancelled.'));
    await expect(compare(FIVE, FIVE, { signal })).rejects.toThrow('Cancelled.');
  });
});
