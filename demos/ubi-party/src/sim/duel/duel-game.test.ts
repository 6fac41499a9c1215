import { describe, expect, it } from 'vitest';
import { AT_REST, STEPS_PER_SECOND, type Controls } from '../game.ts';
import { duelGame, MIN_REACTION_MS, type DuelState } from './duel-game.ts';

const start = (): DuelState => duelGame.start({ seats: [0, 1], seed: 2 });
const nowMs = (state: DuelState): number => (state.step * 1000) / STEPS_PER_SECOND;

/** Plays one bout: each seat's press arrives when `arrives` says, with the time at which it was. */
function bout(
  state: DuelState,
  presses: Record<number, { atMs: number; arrivesMs: number }>,
): void {
  const before = state.decided.length;
  while (state.decided.length === before) {
    const controls = (seat: number): Controls => {
      const press = presses[seat];
      if (!press || nowMs(state) < press.arrivesMs) return AT_REST;
      return { x: 0, y: 0, isPressed: true, pressedAtMs: press.atMs };
    };
    duelGame.step(state, controls, duelGame.settings);
  }
}

describe('Quick Draw', () => {
  it('judges by when the button went down, not by when that arrived', () => {
    const state = start();
    const { signalAtMs } = state.bout;
    bout(state, {
      0: { atMs: signalAtMs + 250, arrivesMs: signalAtMs + 260 },
      1: { atMs: signalAtMs + 240, arrivesMs: signalAtMs + 500 },
    });
    expect(state.decided).toEqual([{ winner: 1, reactionMs: 240 }]);
  });

  it('gives no win for a press before the signal, or too soon after it to be a reaction', () => {
    const state = start();
    const { signalAtMs } = state.bout;
    bout(state, {
      0: { atMs: signalAtMs - 300, arrivesMs: signalAtMs - 280 },
      1: { atMs: signalAtMs + MIN_REACTION_MS - 1, arrivesMs: signalAtMs + 150 },
    });
    expect(state.decided).toEqual([{}]);
  });

  it('does not take a time that is still to come', () => {
    const state = start();
    const { signalAtMs } = state.bout;
    bout(state, {
      0: { atMs: signalAtMs + 1e9, arrivesMs: signalAtMs + 400 },
      1: { atMs: signalAtMs + 300, arrivesMs: signalAtMs + 310 },
    });
    expect(state.decided[0]!.winner).toBe(1);
  });

  it('takes no press in a step before it: a round that catches up makes none too early', () => {
    const state = start();
    while (nowMs(state) < state.bout.signalAtMs - 50)
      duelGame.step(state, () => AT_REST, duelGame.settings);
    const pressedAtMs = state.bout.signalAtMs + 240;
    const controls = (): Controls => ({ x: 0, y: 0, isPressed: true, pressedAtMs });
    while (state.decided.length === 0) duelGame.step(state, controls, duelGame.settings);
    expect(state.decided).toEqual([{ winner: 0, reactionMs: 240 }]);
  });

  it('goes on after five bouts while nobody leads, three times at most', () => {
    const state = start();
    for (let won = 0; won < 4; won += 1) {
      const { signalAtMs } = state.bout;
      bout(state, { [won % 2]: { atMs: signalAtMs + 200, arrivesMs: signalAtMs + 200 } });
    }
    bout(state, {});
    expect(duelGame.isOver(state)).toBe(false);
    expect(duelGame.feedback(state, 0).headline).toBe('Sudden death');
    const { signalAtMs } = state.bout;
    bout(state, { 1: { atMs: signalAtMs + 200, arrivesMs: signalAtMs + 200 } });
    expect(duelGame.isOver(state)).toBe(true);
    expect(duelGame.places(state)).toEqual([[1], [0]]);
  });

  it('does not count a press of one bout in the next', () => {
    const state = start();
    const { signalAtMs } = state.bout;
    const press = { atMs: signalAtMs + 200, arrivesMs: signalAtMs + 210 };
    bout(state, { 0: press });
    bout(state, { 0: press });
    expect(state.decided).toEqual([{ winner: 0, reactionMs: 200 }, {}]);
  });
});
