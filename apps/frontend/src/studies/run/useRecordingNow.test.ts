import { expect, it } from 'vitest';
import { rateBetween } from './useRecordingNow.ts';

it('the rate is what came between two news, and unknown while no time passed', () => {
  const first = { durationMs: 1000, recordCount: 40 };
  expect(rateBetween(first, { durationMs: 1500, recordCount: 90 })).toBe(100);
  expect(rateBetween(first, { durationMs: 2000, recordCount: 40 })).toBe(0);
  expect(rateBetween(first, first)).toBeUndefined();
});
