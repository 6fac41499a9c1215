import { describe, expect, it } from 'vitest';
import { trailParts, withPlace, type Place } from './trail.ts';

const walk = (count: number): readonly Place[] =>
  Array.from({ length: count }, (_, index) => ({ x: index / count, y: 0.5 })).reduce<
    readonly Place[]
  >(withPlace, []);

describe('trailParts()', () => {
  it('has no line before the second position', () => {
    expect(trailParts(walk(0), 300)).toEqual([]);
    expect(trailParts(walk(1), 300)).toEqual([]);
    expect(trailParts(walk(2), 300).map(({ path }) => path)).toEqual(['M0.0 150.0L150.0 150.0']);
  });

  it('is one line from part to part, and fades towards the oldest', () => {
    const parts = trailParts(walk(200), 300);
    expect(parts).toHaveLength(8);
    const ends = parts.map(({ path }) => path.split('L').at(-1));
    const starts = parts.map(({ path }) => path.slice(1).split('L')[0]);
    expect(starts.slice(1)).toEqual(ends.slice(0, -1));
    const opacities = parts.map(({ opacity }) => opacity);
    expect(opacities).toEqual([...opacities].sort((a, b) => a - b));
  });
});
