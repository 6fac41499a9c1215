import { describe, expect, it } from 'vitest';
import { SampleClock } from './sample-clock.ts';

describe('SampleClock', () => {
  it('spreads records that arrive in one bundle over the time they were taken in', () => {
    const clock = new SampleClock();
    clock.toLocalMs(1000, 50_000);
    expect([1010, 1020, 1030].map((taken) => Math.round(clock.toLocalMs(taken, 50_030)))).toEqual([
      50_010, 50_020, 50_030,
    ]);
  });

  it('learns from the fastest record', () => {
    const clock = new SampleClock();
    expect(clock.toLocalMs(1000, 50_080)).toBe(50_080);
    expect(clock.toLocalMs(1010, 50_020)).toBe(50_020);
    expect(clock.toLocalMs(1020, 50_200)).toBeCloseTo(50_030, 0);
  });

  it('takes the arrival when the publisher says nothing', () => {
    expect(new SampleClock().toLocalMs(undefined, 7)).toBe(7);
  });

  it('starts over when the publisher restarts or sets its clock', () => {
    const clock = new SampleClock();
    clock.toLocalMs(1000, 50_000);
    expect(clock.toLocalMs(500, 50_100)).toBe(50_100);
    expect(clock.toLocalMs(90_000, 50_200)).toBe(50_200);
  });

  it('follows a clock that runs slow', () => {
    const clock = new SampleClock();
    let local = 0;
    for (let ms = 0; ms <= 600_000; ms += 100) local = clock.toLocalMs(ms * 0.9999, ms);
    expect(Math.abs(local - 600_000)).toBeLessThan(10);
  });
});
