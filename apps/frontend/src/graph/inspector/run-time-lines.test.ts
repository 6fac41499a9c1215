import { describe, expect, it } from 'vitest';
import { runTimeLines } from './run-time-lines.ts';

const BOX = { width: 60, height: 20 };
const time = (timeMs: number, p50Ms: number, p95Ms: number) => ({ timeMs, p50Ms, p95Ms });

describe('the chart of run times', () => {
  it('shows the last minute, with its slowest run', () => {
    const lines = runTimeLines(
      [time(0, 9, 9), time(30_000, 1, 4), time(61_000, 1, 2)],
      61_000,
      BOX,
    );
    expect(lines.peak?.ms).toBe(4);
    expect(lines.peak?.x).toBeCloseTo(29);
    expect(lines.newest?.p95Ms).toBe(2);
    expect(lines.ends.p95).toBeLessThan(lines.ends.p50);
    expect(lines.ends.p95).toBeCloseTo(10.5);
  });

  it('leaves gaps where nothing ran', () => {
    const lines = runTimeLines(
      [time(0, 1, 1), time(1000, 1, 1), time(9000, 1, 1), time(10_000, 1, 1)],
      10_000,
      BOX,
    );
    expect(lines.p50.match(/M/g)).toHaveLength(2);
  });

  it('is empty before anything ran', () => {
    expect(runTimeLines([], 0, BOX)).toMatchObject({ peak: undefined, newest: undefined });
  });
});
