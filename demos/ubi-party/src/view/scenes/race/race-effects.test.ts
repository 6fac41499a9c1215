import { describe, expect, it } from 'vitest';

import { GAMES, type RaceState } from '../../../sim/index.ts';
import { playWithBots } from '../../../sim/testing/play-with-bots.ts';
import { glanceAtRace, leaderOf, raceEvents, type RaceEvent } from './race-effects.ts';

const start = (): RaceState => GAMES.race.start({ seats: [0, 1, 2], seed: 1 });

describe('race events', () => {
  it('tells hits, boosts, jumps and finishes once', () => {
    const state = start();
    const before = glanceAtRace(state);
    state.step = 9;
    Object.assign(state.carts[0]!, { hitAt: 9, boostSteps: 72 });
    Object.assign(state.carts[1]!, { jumpSteps: 33, finishedAt: 8.5 });
    Object.assign(state.carts[2]!, { liftSteps: 45, hitAt: 9 });
    expect(raceEvents(before, state)).toEqual([
      { type: 'hit', seat: 0 },
      { type: 'boost', seat: 0 },
      { type: 'jump', seat: 1 },
      { type: 'finish', seat: 1 },
      { type: 'lift', seat: 2 },
    ]);
    expect(raceEvents(glanceAtRace(state), state)).toEqual([]);
  });

  it('lets every bot jump once a lap on the figure eight', () => {
    const jumps: RaceEvent[] = [];
    let before: ReturnType<typeof glanceAtRace> | undefined;
    playWithBots(GAMES.race, 3, 1, (now) => {
      if (before) jumps.push(...raceEvents(before, now).filter(({ type }) => type === 'jump'));
      before = glanceAtRace(now);
    });
    expect(jumps.filter(({ seat }) => seat === 0).length).toBeGreaterThanOrEqual(2);
  });

  it('the leader is the first finisher, then the furthest cart', () => {
    const state = start();
    state.carts[1]!.distance = 50;
    expect(leaderOf(state)).toBe(1);
    state.carts[2]!.finishedAt = 4000;
    expect(leaderOf(state)).toBe(2);
    expect(leaderOf({ ...state, carts: [] })).toBeUndefined();
  });
});
