import { describe, expect, it } from 'vitest';

import { podiumSpots, STEPS } from './podium-steps.ts';

const seats = (count: number): number[] => Array.from({ length: count }, (_, seat) => seat);

describe('podium spots', () => {
  it('lift the first three onto their steps', () => {
    const spots = podiumSpots(seats(6), [4, 0, 5]);
    const heights = [4, 0, 5].map((seat) => spots.find((spot) => spot.seat === seat)!.y);
    expect(heights).toEqual(
      [1, 2, 3].map((place) => STEPS.find((step) => step.place === place)!.height),
    );
    expect(spots.filter(({ y }) => y === 0).map(({ seat }) => seat)).toEqual([1, 2, 3]);
  });

  it('leave steps empty when fewer play', () => {
    expect(podiumSpots([2, 7], [7, 2]).map(({ place }) => place)).toEqual([1, 2]);
    expect(podiumSpots([], [])).toEqual([]);
  });

  it('give 32 a spot of their own', () => {
    const spots = podiumSpots(seats(32), [31, 30, 29]);
    expect(new Set(spots.map(({ x, z }) => `${x} ${z}`)).size).toBe(32);
    const others = spots.filter(({ place }) => place === 0);
    for (const { x, z } of others) {
      expect(Math.abs(x)).toBeLessThan(11);
      expect(z).toBeGreaterThan(1.5);
    }
  });
});
