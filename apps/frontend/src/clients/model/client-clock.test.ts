import { describe, expect, it } from 'vitest';
import { aView } from '../testing/a-client.ts';
import { clockAhead, clockError, clockOf } from './client-clock.ts';

const clock = (offsetMs: number, errorMs = 1.44) => ({ offsetMs, errorMs, driftPpm: 0, ageMs: 0 });

describe('the clock of a client [TS-10]', () => {
  it.each([
    [-12.3, '+12', 'ms'],
    [2_345, '−2.3', 's'],
    [-1_800_000, '+30.0', 'min'],
    [36_000_000, '−10.0', 'h'],
    [1.2, '0', 'ms'],
  ])('of which the master is ahead by %d ms is %s %s', (offsetMs, digits, unit) => {
    expect(clockAhead(clock(offsetMs))).toEqual({ digits, unit });
  });

  it('says how certain that is', () => {
    expect(clockError(clock(0))).toBe('±1.4 ms');
    expect(clockError(clock(0, 250))).toBe('±250 ms');
    expect(clockError(clock(0, 2_500))).toBe('±2.5 s');
  });

  it('is known of clients that are here and say it', () => {
    expect(clockOf(aView('a', { clock: clock(3) }))).toEqual(clock(3));
    expect(clockOf(aView('a', { clock: clock(3), connected: false }))).toBeUndefined();
    expect(clockOf(aView('a'))).toBeUndefined();
  });
});
