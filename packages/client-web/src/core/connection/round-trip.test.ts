import { describe, expect, it } from 'vitest';
import { RoundTripWindow } from './round-trip.ts';

describe('RoundTripWindow', () => {
  it('has nothing to say before the first measurement', () => {
    expect(new RoundTripWindow().current).toBeUndefined();
  });

  it('gives the percentiles by nearest rank', () => {
    const window = new RoundTripWindow();
    for (let ms = 20; ms >= 1; ms--) window.add(ms);
    expect(window.current).toEqual({ lastMs: 1, p50Ms: 10, p95Ms: 19 });
  });

  it('forgets all but the last 60', () => {
    const window = new RoundTripWindow();
    for (let i = 0; i < 60; i++) window.add(1_000);
    for (let i = 0; i < 60; i++) window.add(5);
    expect(window.current).toEqual({ lastMs: 5, p50Ms: 5, p95Ms: 5 });
  });

  it('starts again when cleared', () => {
    const window = new RoundTripWindow();
    window.add(5);
    window.clear();
    expect(window.current).toBeUndefined();
  });
});
