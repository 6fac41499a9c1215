import { describe, expect, it } from 'vitest';

import { DEFAULT_LIMITS } from '../limits/index.ts';
import { budgetOf } from './budget.ts';

const limits = {
  ...DEFAULT_LIMITS,
  recordingMs: 60_000,
  recordingBytes: 1e9,
  recordingFreeBytes: 1e8,
};

describe('the budget of a recording [RC-16]', () => {
  it('is that of the master where it says nothing', () => {
    const all = { maxDurationMs: 60_000, maxBytes: 1e9, minFreeBytes: 1e8 };
    expect(budgetOf(undefined, limits)).toEqual(all);
    expect(budgetOf({ maxDurationMs: 0, maxBytes: 0, minFreeBytes: 0 }, limits)).toEqual(all);
  });

  it('is within the time and size of the master, and asks for any free space', () => {
    expect(budgetOf({ maxDurationMs: 1_000, maxBytes: 5_000, minFreeBytes: 7 }, limits)).toEqual({
      maxDurationMs: 1_000,
      maxBytes: 5_000,
      minFreeBytes: 7,
    });
    expect(budgetOf({ maxDurationMs: 1e9, maxBytes: 1e12, minFreeBytes: 1e12 }, limits)).toEqual({
      maxDurationMs: 60_000,
      maxBytes: 1e9,
      minFreeBytes: 1e12,
    });
  });

  it('has numbers from 0 on', () => {
    const budget = { maxDurationMs: -1, maxBytes: 0, minFreeBytes: 0 };
    expect(() => budgetOf(budget, limits)).toThrow('maxDurationMs -1');
    expect(() => budgetOf({ ...budget, maxDurationMs: Number.NaN }, limits)).toThrow('NaN');
  });
});
