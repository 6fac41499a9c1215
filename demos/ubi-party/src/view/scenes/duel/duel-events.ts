import { isSignalled, type DuelState, type Seat } from '../../../sim/index.ts';

/** An event of the duel. */
export type DuelEvent =
  | { readonly type: 'signal' }
  | { readonly type: 'press'; readonly seat: Seat }
  | { readonly type: 'won'; readonly seat: Seat };

/** Copy of the compared values of a state, which the game changes in place. */
export interface DuelGlance {
  readonly step: number;
  readonly bouts: number;
  readonly isSignalled: boolean;
  readonly pressed: ReadonlySet<Seat>;
}

export function glanceAtDuel(state: DuelState): DuelGlance {
  return {
    step: state.step,
    bouts: state.decided.length,
    isSignalled: isSignalled(state),
    pressed: new Set(state.seats.filter((seat) => seat in state.bout.presses)),
  };
}

/** Events between two states of a round; none when the second is of an earlier time, as in a replay. */
export function duelEvents(before: DuelGlance, state: DuelState): DuelEvent[] {
  if (state.step < before.step) return [];
  const isNewBout = state.decided.length > before.bouts;
  const events: DuelEvent[] = [];
  if (isSignalled(state) && (isNewBout || !before.isSignalled)) events.push({ type: 'signal' });
  for (const seat of state.seats) {
    const wasPressed = !isNewBout && before.pressed.has(seat);
    if (seat in state.bout.presses && !wasPressed) events.push({ type: 'press', seat });
  }
  const winner = isNewBout ? state.decided.at(-1)?.winner : undefined;
  if (winner !== undefined) events.push({ type: 'won', seat: winner });
  return events;
}

/** Whether a player pressed before the flag fell: out until the next bout. */
export function isEarly({ bout }: DuelState, seat: Seat): boolean {
  const pressedAtMs = bout.presses[seat];
  return pressedAtMs !== undefined && pressedAtMs < bout.signalAtMs;
}

/** Seconds that the flag takes to fall, and to be raised again. */
const FALL_S = 0.2;
const RAISE_S = 0.6;

/** Height of the flag in the next frame, 0 to 1. It falls like a stone and is raised at constant speed. */
export function nextFlag(height: number, isFallen: boolean, dtS: number): number {
  if (!isFallen) return Math.min(1, height + dtS / RAISE_S);
  const fallenS = FALL_S * Math.sqrt(Math.max(0, 1 - height)) + dtS;
  return Math.max(0, 1 - (fallenS / FALL_S) ** 2);
}
