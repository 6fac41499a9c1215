import { describe, expect, it } from 'vitest';

import { nextQuality, startQuality, FrameMeter, type QualityState } from './quality.ts';

const after = (state: QualityState, windows: readonly number[]): QualityState =>
  windows.reduce(nextQuality, state);
const times = (count: number, p95Ms: number): number[] => Array<number>(count).fill(p95Ms);

describe('quality', () => {
  it('goes down after two slow windows, not after one', () => {
    expect(after(startQuality('high'), [40]).quality).toBe('high');
    expect(after(startQuality('high'), [40, 16, 40]).quality).toBe('high');
    expect(after(startQuality('high'), [40, 40]).quality).toBe('middle');
    expect(after(startQuality('high'), times(4, 40)).quality).toBe('low');
    expect(after(startQuality('low'), times(9, 40)).quality).toBe('low');
  });

  it('goes up after four fast windows', () => {
    expect(after(startQuality('low'), times(3, 16)).quality).toBe('low');
    expect(after(startQuality('low'), times(4, 16)).quality).toBe('middle');
    expect(after(startQuality('low'), times(8, 16)).quality).toBe('high');
  });

  it('keeps its level between the limits', () => {
    expect(after(startQuality('middle'), times(50, 21)).quality).toBe('middle');
  });

  it('finds its level on a device that is fast enough for one level only', () => {
    let state = startQuality('high');
    const changes: string[] = [];
    for (let window = 0; window < 500; window += 1) {
      const next = nextQuality(state, state.quality === 'high' ? 40 : 16);
      if (next.quality !== state.quality) changes.push(next.quality);
      state = next;
    }
    expect(state.quality).toBe('middle');
    expect(changes).toHaveLength(5);
  });
});

const take = (meter: FrameMeter, gapMs: number, frames: number): void => {
  for (let frame = 0; frame < frames; frame += 1) meter.take(gapMs);
};

describe('frame meter', () => {
  it('goes down on a device that is slow, also on a very slow one', () => {
    for (const gapMs of [40, 700, 3000]) {
      const meter = new FrameMeter('high');
      take(meter, gapMs, Math.max(4, Math.ceil(9000 / gapMs)));
      expect(meter.quality).not.toBe('high');
      expect(meter.p95Ms).toBe(gapMs);
    }
  });

  it('takes single late frames and pauses for what they are', () => {
    const meter = new FrameMeter('high');
    for (let second = 0; second < 20; second += 1) {
      take(meter, 16.7, 60);
      meter.take(90);
      meter.take(30_000);
    }
    expect(meter.quality).toBe('high');
    expect(meter.p95Ms).toBe(16.7);
  });
});
