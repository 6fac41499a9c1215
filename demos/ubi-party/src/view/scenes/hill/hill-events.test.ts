import { describe, expect, it } from 'vitest';
import { GAMES, type HillState } from '../../../sim/index.ts';
import { playWithBots } from '../../../sim/testing/play-with-bots.ts';
import { glanceAtHill, hillEvents, type HillEvent } from './hill-events.ts';

const start = (): HillState => GAMES.hill.start({ seats: [0, 1, 2], seed: 3 });

describe('hill events', () => {
  it('tells a push of two pieces once, between them', () => {
    const state = start();
    const before = glanceAtHill(state);
    state.step = 5;
    Object.assign(state.pieces[0]!.position, { x: 1, y: 2 });
    Object.assign(state.pieces[2]!.position, { x: 3, y: 2 });
    state.pieces[0]!.lastPush = { by: 2, at: 5 };
    state.pieces[2]!.lastPush = { by: 0, at: 5 };
    expect(hillEvents(before, state)).toEqual([{ type: 'push', seats: [0, 2], x: 2, y: 2 }]);
    expect(hillEvents(glanceAtHill(state), state)).toEqual([]);
  });

  it('tells falls, dashes, powers and a new crown', () => {
    const state = start();
    const before = glanceAtHill(state);
    state.step = 9;
    state.pieces[0]!.outAt = 9;
    state.pieces[1]!.dashUntil = 30;
    state.pieces[2]!.power = { kind: 'spring', until: 300 };
    state.crown = 1;
    expect(hillEvents(before, state)).toEqual([
      { type: 'fall', seat: 0 },
      { type: 'dash', seat: 1 },
      { type: 'power', seat: 2, kind: 'spring' },
      { type: 'crown', seat: 1 },
    ]);
  });

  it('tells nothing when the round begins again', () => {
    const state = start();
    state.step = 100;
    state.crown = 2;
    expect(hillEvents(glanceAtHill(state), start())).toEqual([]);
  });

  it('tells as many falls as pieces fell in a round of bots', () => {
    const events: HillEvent[] = [];
    let before = glanceAtHill(GAMES.hill.start({ seats: [0, 1, 2, 3, 4, 5], seed: 7 }));
    const state = playWithBots(GAMES.hill, 6, 7, (now) => {
      events.push(...hillEvents(before, now));
      before = glanceAtHill(now);
    });
    const fallen = state.pieces.filter(({ outAt }) => outAt !== undefined);
    expect(events.filter(({ type }) => type === 'fall')).toHaveLength(fallen.length);
    expect(events.filter(({ type }) => type === 'push').length).toBeGreaterThan(0);
  });
});
