import { describe, expect, it } from 'vitest';

import { MAX_SEATS } from '../../../sim/index.ts';
import { lobbyPlan, lobbySize, lobbySpot } from './lobby-scene.ts';

describe('lobby spots', () => {
  it.each([7, 8, 17, 18, 31])(
    'give all seats up to %i a place of their own on the table',
    (highest) => {
      const plan = lobbyPlan(highest);
      const { half, depth } = lobbySize(plan);
      const spots = Array.from({ length: highest + 1 }, (_, seat) => lobbySpot(seat, plan));
      for (const [index, a] of spots.entries()) {
        expect(Math.abs(a.x)).toBeLessThan(half + 0.6);
        expect(a.z).toBeGreaterThan(-depth - 0.5);
        for (const b of spots.slice(index + 1)) {
          expect(Math.abs(a.x - b.x) > 2.3 || Math.abs(a.z - b.z) > 4).toBe(true);
        }
      }
    },
  );

  it('keep the place of a seat while the table is large enough', () => {
    expect(lobbyPlan(3)).toBe(lobbyPlan(7));
    expect(lobbyPlan(MAX_SEATS - 1).seats).toBe(MAX_SEATS);
  });
});
