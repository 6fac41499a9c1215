import { describe, expect, it } from 'vitest';

import { GAMES, trackOf, type RaceState } from '../../../sim/index.ts';
import { closeIn } from './race-scene.ts';

const race = (xs: readonly number[], distance: number): RaceState => {
  const state = GAMES.race.start({ seats: xs.map((_, seat) => seat), seed: 0 });
  for (const [index, cart] of state.carts.entries()) {
    Object.assign(cart, { distance, position: { x: xs[index]!, y: 4 } });
  }
  return state;
};

describe('closing in', () => {
  const track = trackOf(race([0], 0));
  const lastLap = track.length * 2.2;

  it('is for the last lap', () => {
    expect(closeIn(race([10, 20], track.length), track, 30).zoom).toBe(1);
    expect(closeIn(race([10, 20], lastLap), track, 30)).toEqual({ zoom: 1.15, x: 15, z: -4 });
  });

  it('keeps carts in the picture that are far apart', () => {
    expect(closeIn(race([-29, 29], lastLap), track, 30).zoom).toBe(1);
  });

  it('follows those who still drive', () => {
    const state = race([-29, 20], lastLap);
    state.carts[0]!.finishedAt = 100;
    expect(closeIn(state, track, 30)).toEqual({ zoom: 1.15, x: 20, z: -4 });
  });
});
