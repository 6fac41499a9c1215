import { describe, expect, it } from 'vitest';
import { Random } from './random.ts';

describe('Random', () => {
  it('gives the same numbers for the same seed, and others for another', () => {
    const numbers = (seed: number) => {
      const random = new Random(seed);
      return Array.from({ length: 8 }, () => random.next());
    };
    expect(numbers(7)).toEqual(numbers(7));
    expect(numbers(7)).not.toEqual(numbers(8));
    expect(new Set(numbers(0)).size).toBe(8);
  });

  it('stays below its bound', () => {
    const random = new Random(1);
    for (let i = 0; i < 1000; i++) expect(random.below(7)).toBeLessThan(7);
    expect(random.below(0)).toBe(0);
  });
});
