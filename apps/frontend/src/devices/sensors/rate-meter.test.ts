import { describe, expect, it } from 'vitest';
import { RateMeter } from './rate-meter.ts';

describe('a rate meter', () => {
  it('says what it measured, not what was promised', () => {
    const meter = new RateMeter();
    for (let i = 0; i <= 100; i++) meter.note(i * 16);
    expect(meter.rateHz(1600)).toBeCloseTo(62.5, 10);
  });

  it('knows no rate of nothing, of one moment, and of what has ended', () => {
    const meter = new RateMeter();
    expect(meter.rateHz(0)).toBeUndefined();
    meter.note(0);
    expect(meter.rateHz(0)).toBeUndefined();
    meter.note(10);
    expect(meter.rateHz(10)).toBe(100);
    expect(meter.rateHz(1011)).toBeUndefined();
  });

  it('follows a change within the last moments', () => {
    const meter = new RateMeter();
    for (let i = 0; i < 100; i++) meter.note(i);
    for (let i = 1; i < 40; i++) meter.note(99 + i * 100);
    expect(meter.rateHz(4000)).toBeCloseTo(10, 10);
  });

  it('measures runs per second of a counter', () => {
    const meter = new RateMeter(1000, 1000);
    for (let i = 0; i <= 20; i++) meter.note(i * 250, 7 + (i % 2));
    expect(meter.rateHz(5000)).toBeCloseTo(30, 10);
    for (let i = 1; i <= 5; i++) meter.note(5000 + i * 250, 0);
    expect(meter.rateHz(6250)).toBe(0);
  });

  it('knows nothing of what was before it was cleared', () => {
    const meter = new RateMeter();
    for (let i = 0; i < 10; i++) meter.note(i * 500);
    meter.clear();
    meter.note(4600);
    expect(meter.rateHz(4600)).toBeUndefined();
    meter.note(4610);
    expect(meter.rateHz(4610)).toBe(100);
  });
});
