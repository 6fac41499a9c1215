import { describe, expect, it } from 'vitest';
import { TimeBudget } from './time-budget.ts';

/** A call that looks once a millisecond of its own, and then waits. */
function aCall(options: { readonly waitMs: number; readonly hasCpuTime: boolean }) {
  let nowMs = 0;
  let cpuMs = 0;
  const budget = new TimeBudget(() => nowMs, options.hasCpuTime ? () => cpuMs : undefined);
  budget.begin(500);
  budget.enter();
  const compute = (ms: number): void => {
    for (let i = 0; i < ms && !budget.isSpent; i++) {
      cpuMs += 1;
      nowMs += 1 + options.waitMs;
      budget.look();
    }
  };
  return { budget, compute, cpuMs: () => cpuMs };
}

describe('the time of a call', () => {
  it('is spent when the call has computed for so long', () => {
    const { budget, compute, cpuMs } = aCall({ waitMs: 0, hasCpuTime: true });
    compute(490);
    expect(budget.isSpent).toBe(false);
    compute(20);
    expect(budget.isSpent).toBe(true);
    expect(cpuMs()).toBeLessThanOrEqual(501);
  });

  it('does not contain the time in which the thread waits for a processor', () => {
    const { budget, compute, cpuMs } = aCall({ waitMs: 12, hasCpuTime: true });
    compute(450);
    expect(budget.isSpent).toBe(false);
    compute(100);
    expect(budget.isSpent).toBe(true);
    expect(cpuMs()).toBeGreaterThan(470);
  });

  it('contains short waits where the CPU time is not known, and no long ones', () => {
    const short = aCall({ waitMs: 12, hasCpuTime: false });
    short.compute(60);
    expect(short.budget.isSpent).toBe(true);
    const long = aCall({ waitMs: 1000, hasCpuTime: false });
    long.compute(15);
    expect(long.budget.isSpent).toBe(false);
  });
});
