import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { NearSignal } from './near-signal.ts';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

describe('NearSignal', () => {
  it('shows what it is told, and holds as long as it is told again', () => {
    const shown: boolean[] = [];
    const signal = new NearSignal((isNear) => shown.push(isNear));
    for (let i = 0; i < 5; i++) {
      signal.handle(true);
      vi.advanceTimersByTime(1_000);
    }
    expect(shown.every(Boolean)).toBe(true);
    signal.handle(false);
    vi.advanceTimersByTime(10_000);
    expect(shown.slice(-2)).toEqual([true, false]);
  });

  it('lets go of a session that was stopped elsewhere', () => {
    const shown: boolean[] = [];
    const signal = new NearSignal((isNear) => shown.push(isNear));
    signal.handle(true);
    vi.advanceTimersByTime(1_500);
    expect(shown).toEqual([true, false]);
  });

  it('shows nothing once it has ended', () => {
    const shown: boolean[] = [];
    const signal = new NearSignal((isNear) => shown.push(isNear));
    signal.handle(true);
    signal.end();
    vi.advanceTimersByTime(10_000);
    expect(shown).toEqual([true]);
  });
});
