import { describe, expect, it } from 'vitest';
import { FrameMeter } from './frame-meter.ts';

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
