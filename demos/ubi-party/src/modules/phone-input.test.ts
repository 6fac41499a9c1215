import { describe, expect, it } from 'vitest';

import { judgeOnce, judgeTime, UNKNOWN_DELAY, type JudgedTime } from './phone-input.ts';

const ARRIVED_MS = 1_000_000;
const before = (ms: number): number => ARRIVED_MS - ms;

describe('the time of a press', () => {
  it.each([
    ['of a phone with 150 ms lag is what the phone says', 75, { leastMs: 71, mostMs: 79 }, 75],
    ['may be late by as much as the lag varies', 140, { leastMs: 71, mostMs: 150 }, 140],
    ['is bounded where a phone claims too much', 400, { leastMs: 0, mostMs: 7 }, 7],
    ['is bounded where a clock is behind', 230, { leastMs: 71, mostMs: 79 }, 79],
    ['is bounded where a clock is ahead', -120, { leastMs: 71, mostMs: 79 }, 71],
    ['is near the arrival while nothing was measured', 400, UNKNOWN_DELAY, UNKNOWN_DELAY.mostMs],
  ])('%s', (_what, claimedAgoMs, delay, judgedAgoMs) => {
    expect(judgeTime(before(claimedAgoMs), ARRIVED_MS, delay)).toBe(before(judgedAgoMs));
  });

  it('is judged once, whatever is measured afterwards', () => {
    const judged: Record<number, JudgedTime> = {};
    const judge = (claimedAgoMs: number, mostMs: number) =>
      judgeOnce(judged, 3, before(claimedAgoMs), ARRIVED_MS, { leastMs: 0, mostMs });
    expect(judge(400, 7)).toEqual({ judgedMs: before(7), isNew: true });
    expect(judge(400, 200)).toEqual({ judgedMs: before(7), isNew: false });
    expect(judge(50, 200)).toEqual({ judgedMs: before(50), isNew: true });
  });
});
