import { expect, it } from 'vitest';
import { StageTimes, type ResultTimes } from './stage-times.ts';

const result = (changes: Partial<ResultTimes> = {}): ResultTimes => ({
  takenMs: 1000,
  encodeMs: 5,
  finishedMs: 1050,
  durationMs: 35,
  arrivedMs: 1054,
  drawnMs: 1062,
  ...changes,
});
const parts = (times: StageTimes): readonly number[] | undefined =>
  times.summary(1062)?.stages.map(({ ms }) => ms);

it('the parts of the way sum up to the age of what is seen', () => {
  const times = new StageTimes();
  times.add(result());
  const { stages, p50Ms, count } = times.summary(1062)!;
  expect(stages.map(({ name, ms }) => `${name} ${ms}`)).toEqual([
    'Encode 5',
    'To the module 10',
    'Detect 35',
    'Back 4',
    'Draw 8',
  ]);
  expect(stages.reduce((sum, { ms }) => sum + ms, 0)).toBe(p50Ms);
  expect(count).toBe(1);
});

it('tells capture and decoding apart where they are known, and how sure the clocks are', () => {
  const times = new StageTimes();
  times.add(result({ takenMs: 980, captureMs: 20, decodeMs: 12 }));
  const { stages, p50Ms } = times.summary(1062, 1.5)!;
  expect(stages.map(({ name, ms, errorMs }) => [name, ms, errorMs])).toEqual([
    ['Capture', 20, undefined],
    ['Encode', 5, undefined],
    ['To the module', 10, 1.5],
    ['Decode', 12, undefined],
    ['Detect', 23, undefined],
    ['Back', 4, 1.5],
    ['Draw', 8, undefined],
  ]);
  expect(p50Ms).toBe(82);
});

it('gives medians, and the 95th percentile of the whole', () => {
  const times = new StageTimes();
  for (let late = 0; late < 20; late++) times.add(result({ drawnMs: 1062 + late }));
  expect(parts(times)?.at(-1)).toBe(17);
  expect(parts(times)?.reduce((sum, ms) => sum + ms, 0)).toBe(71);
  expect(times.summary(1081)).toMatchObject({ p50Ms: 71, p95Ms: 80, count: 20 });
});

it('the parts sum up to the median also where each is slow at another time', () => {
  const times = new StageTimes();
  for (let i = 0; i < 30; i++) {
    const slow = {
      detect: i % 3 === 0 ? 60 : 0,
      draw: i % 3 === 1 ? 60 : 0,
      back: i % 3 === 2 ? 60 : 0,
    };
    const finishedMs = 1050 + slow.detect;
    const arrivedMs = finishedMs + 4 + slow.back;
    const drawnMs = arrivedMs + 8 + slow.draw;
    times.add(result({ durationMs: 35 + slow.detect, finishedMs, arrivedMs, drawnMs }));
  }
  const { stages, p50Ms } = times.summary(1200)!;
  expect(stages.reduce((sum, { ms }) => sum + ms, 0)).toBeCloseTo(p50Ms);
});

it('a clock that is off by a little gives no time below 0', () => {
  const times = new StageTimes();
  times.add(result({ arrivedMs: 1049.5, drawnMs: 1049.5 }));
  expect(parts(times)).toEqual([5, 10, 35, 0, 0]);
});

it('forgets results after ten seconds, and takes none without a time', () => {
  const times = new StageTimes();
  times.add(result({ takenMs: Number.NaN }));
  expect(times.summary(1062)).toBeUndefined();
  times.add(result());
  expect(times.summary(11_063)).toBeUndefined();
});

it('mixes nothing of another source: pictures that were under way do not count', () => {
  const times = new StageTimes();
  times.add(result());
  times.clear(1005);
  times.add(result({ takenMs: 1000, drawnMs: 2500 }));
  expect(times.summary(2500)).toBeUndefined();
  times.add(result({ takenMs: 1010, drawnMs: 1090 }));
  expect(times.summary(2500)).toMatchObject({ p50Ms: 80, count: 1 });
});
