import { describe, expect, it } from 'vitest';
import type { RecordLine } from '../history/topic-history.ts';
import { lateAfterMs } from './record-table.ts';

const linesOf = (deltas: readonly (number | undefined)[]) =>
  deltas.map((deltaMs, number): RecordLine => ({
    number,
    timeMs: 0,
    arrivalMs: 0,
    deltaMs,
    numbers: undefined,
    text: '',
  }));

describe('lateAfterMs', () => {
  it('marks what is well beyond the usual distance', () => {
    const late = lateAfterMs(linesOf([10, 10.1, 9.9, 20.2, 10, 10, 9.8, 10.1, 10]))!;
    expect(late).toBeGreaterThan(10.1);
    expect(late).toBeLessThan(20.2);
  });

  it('leaves the noise of short distances alone', () => {
    expect(lateAfterMs(linesOf([1, 1, 1, 3, 1, 1, 2, 1, 1]))).toBe(5);
  });

  it('does not judge a few records', () => {
    expect(lateAfterMs(linesOf([undefined, 10, 99]))).toBeUndefined();
  });
});
