import { describe, expect, it } from 'vitest';
import { timestampFromMs, timestampToMs } from './timestamp.ts';

const NOW_MS = 1763722000123.25;

describe('timestamps', () => {
  it('are written into all three fields', () => {
    expect(timestampFromMs(NOW_MS)).toEqual({
      seconds: 1763722000,
      nanos: 123_250_000,
      millis: 1763722000123,
    });
    expect(timestampFromMs(1999.9999999).nanos).toBeLessThan(1e9);
  });

  it('come back, the fraction included', () => {
    expect(timestampToMs(timestampFromMs(NOW_MS))).toBe(NOW_MS);
  });

  it.each([
    ['Node.js: millis alone', { seconds: 0, nanos: 0, millis: 1763722000123 }, 1763722000123],
    [
      'older browsers: seconds and nanos',
      { seconds: 1763722000, nanos: 5e8, millis: 0 },
      1763722000500,
    ],
    [
      'fields that disagree: millis',
      { seconds: 1763720000, nanos: 0, millis: 1763722000123 },
      1763722000123,
    ],
    ['newer browsers: time since page load', { seconds: 0, nanos: 0, millis: 4211 }, undefined],
    ['Unity: second of the minute', { seconds: 42, nanos: 1000, millis: 0 }, undefined],
    ['an empty timestamp', { seconds: 0, nanos: 0, millis: 0 }, undefined],
    ['no timestamp', undefined, undefined],
  ])('%s', (_name, timestamp, expected) => {
    expect(timestampToMs(timestamp)).toBe(expected);
  });
});
