import { describe, expect, it } from 'vitest';

import { StepClock } from './motion.ts';

const STEP_MS = 1000 / 60;

describe('step clock', () => {
  it('is at the state when states come evenly', () => {
    const clock = new StepClock();
    for (let step = 0; step < 60; step += 1) clock.take(step, 500 + step * STEP_MS);
    expect(clock.aheadS(500 + 59 * STEP_MS)).toBeCloseTo(0, 6);
    expect(clock.aheadS(500 + 59.5 * STEP_MS)).toBeCloseTo(0.5 / 60, 6);
  });

  it('moves evenly when states come in pairs', () => {
    const clock = new StepClock();
    const drawn: number[] = [];
    for (let step = 0; step < 240; step += 2) {
      const nowMs = step * STEP_MS;
      clock.take(step, nowMs);
      // The second state of the pair comes with the first
      clock.take(step + 1, nowMs);
      for (const at of [nowMs, nowMs + STEP_MS]) drawn.push((step + 1) / 60 + clock.aheadS(at));
    }
    const moves = drawn.slice(-40).map((at, index, all) => (index ? at - all[index - 1]! : 1 / 60));
    expect(Math.min(...moves)).toBeGreaterThan(0.6 / 60);
    expect(Math.max(...moves)).toBeLessThan(1.4 / 60);
  });

  it('never lags or runs ahead by more than a step', () => {
    const clock = new StepClock();
    clock.take(10, 1000);
    expect(clock.aheadS(9000)).toBeCloseTo(1 / 60, 9);
    expect(clock.aheadS(0)).toBeCloseTo(-1 / 60, 9);
  });

  it('begins again when steps go back', () => {
    const clock = new StepClock();
    clock.take(600, 10_000);
    clock.take(0, 10_020);
    expect(clock.aheadS(10_020)).toBe(0);
  });
});
