import { expect, it } from 'vitest';
import { Overruns } from './overruns.ts';

/** Feeds one report a second. @returns whether the module was late after each */
function late(reports: readonly (readonly [runs: number, overruns: number])[]): boolean[] {
  const watch = new Overruns();
  return reports.map(([runs, overruns], index) =>
    watch.report({ moduleId: 'map', runs, overruns }, index * 1000),
  );
}

it('a module whose runs take longer than its interval is late, until they no longer do', () => {
  expect(
    late([
      [0, 0],
      [10, 10],
      [20, 20],
    ]),
  ).toEqual([false, true, true]);
  const after = Array.from({ length: 7 }, (_, index) => [100 + 30 * index, 20] as const);
  expect(late([[0, 0], [20, 20], ...after]).at(-1)).toBe(false);
});

it('a single long run, as at the start, is no fault', () => {
  expect(
    late([
      [0, 0],
      [30, 1],
      [60, 1],
    ]),
  ).toEqual([false, false, false]);
});

it('a module that was started again counts from there', () => {
  expect(
    late([
      [100, 50],
      [0, 0],
      [30, 0],
    ]),
  ).toEqual([false, false, false]);
});
