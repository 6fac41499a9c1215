import { describe, expect, it } from 'vitest';
import { GAMES, isSignalled } from '../../../sim/index.ts';
import { playWithBots } from '../../../sim/testing/play-with-bots.ts';
import {
  duelEvents,
  glanceAtDuel,
  isEarly,
  nextFlag,
  duelSpots,
  type DuelEvent,
} from './duel-scene.ts';

describe('duel events', () => {
  it('tell the signal and the winner of each bout of bots once', () => {
    const events: DuelEvent[] = [];
    let before: ReturnType<typeof glanceAtDuel> | undefined;
    const state = playWithBots(GAMES.duel, 4, 9, (now) => {
      if (before) events.push(...duelEvents(before, now));
      before = glanceAtDuel(now);
    });
    const of = (type: DuelEvent['type']): number =>
      events.filter((event) => event.type === type).length;
    expect(of('signal')).toBe(state.decided.length);
    expect(of('won')).toBe(state.decided.filter(({ winner }) => winner !== undefined).length);
    expect(of('press')).toBe(state.decided.length * 4);
  });

  it('tell nothing when the round begins again', () => {
    const start = () => GAMES.duel.start({ seats: [0, 1], seed: 1 });
    const later = start();
    later.step = 400;
    expect(duelEvents(glanceAtDuel(later), start())).toEqual([]);
  });

  it('a press before the flag is early', () => {
    const state = GAMES.duel.start({ seats: [0, 1], seed: 1 });
    state.bout.presses[0] = state.bout.signalAtMs - 10;
    state.bout.presses[1] = state.bout.signalAtMs + 300;
    expect([isEarly(state, 0), isEarly(state, 1), isEarly(state, 2)]).toEqual([true, false, false]);
    expect(isSignalled(state)).toBe(false);
  });
});

describe('flag', () => {
  it('falls within a quarter of a second, faster and faster, and is raised again', () => {
    const heights = [1];
    for (let frame = 0; frame < 15; frame += 1)
      heights.push(nextFlag(heights.at(-1)!, true, 1 / 60));
    expect(heights.at(-1)).toBe(0);
    expect(heights[1]! - heights[2]!).toBeGreaterThan(heights[0]! - heights[1]!);
    let height = 0;
    for (let frame = 0; frame < 60; frame += 1) height = nextFlag(height, false, 1 / 60);
    expect(height).toBe(1);
  });
});

describe('duel spots', () => {
  it.each([2, 8, 9, 32])('give %i players room for their tokens', (count) => {
    const spots = duelSpots(Array.from({ length: count }, (_, seat) => seat));
    expect(new Set(spots.map(({ z }) => z)).size).toBe(count < 9 ? 1 : 2);
    for (const [index, a] of spots.entries()) {
      for (const b of spots.slice(index + 1)) {
        expect(a.z !== b.z || Math.abs(a.x - b.x) > 2.4).toBe(true);
      }
    }
  });
});
