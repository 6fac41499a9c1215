import { describe, expect, it } from 'vitest';
import { ValueAxis } from './value-axis.ts';

describe('ValueAxis', () => {
  it('leaves room around the values', () => {
    const { min, max } = new ValueAxis().follow({ min: 0, max: 10 }, 0);
    expect(min).toBeCloseTo(-0.8);
    expect(max).toBeCloseTo(10.8);
  });

  it('shows a constant in the middle', () => {
    const { min, max } = new ValueAxis().follow({ min: 5, max: 5 }, 0);
    expect((min + max) / 2).toBe(5);
    expect(max).toBeGreaterThan(min);
  });

  it('lies evenly around the first values, whatever the very first one was', () => {
    const axis = new ValueAxis();
    axis.follow({ min: 0.9, max: 0.9 }, 0);
    axis.follow({ min: 0.2, max: 0.9 }, 10);
    const { min, max } = axis.follow({ min: -1, max: 1 }, 20);
    expect(min).toBeCloseTo(-1.16);
    expect(max).toBeCloseTo(1.16);
  });

  it('opens at once and stays while values move within', () => {
    const axis = new ValueAxis();
    axis.follow({ min: 0, max: 10 }, 0);
    const opened = axis.follow({ min: 0, max: 20 }, 10);
    expect(opened.max).toBeGreaterThan(20);
    expect(axis.follow({ min: 1, max: 19 }, 20)).toBe(opened);
  });

  it('closes in only when the values need little of it for a while', () => {
    const axis = new ValueAxis();
    const wide = axis.follow({ min: 0, max: 100 }, 0);
    expect(axis.follow({ min: 4, max: 6 }, 100)).toBe(wide);
    expect(axis.follow({ min: 4, max: 80 }, 1500)).toBe(wide);
    expect(axis.follow({ min: 4, max: 6 }, 2200)).toBe(wide);
    expect(axis.follow({ min: 4, max: 6 }, 4300).max).toBeLessThan(7);
  });

  it('moves to values that are somewhere else', () => {
    const axis = new ValueAxis();
    axis.follow({ min: 0, max: 1 }, 0);
    expect(axis.follow({ min: 1000, max: 1001 }, 10).min).toBeGreaterThan(900);
  });

  it('keeps its range while there is nothing', () => {
    const axis = new ValueAxis();
    expect(axis.follow(undefined, 0)).toEqual({ min: -1, max: 1 });
    const range = axis.follow({ min: 0, max: 10 }, 0);
    expect(axis.follow(undefined, 10)).toBe(range);
  });
});
