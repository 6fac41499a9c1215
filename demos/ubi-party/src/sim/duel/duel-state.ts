import type { WithPace } from '../game.ts';
import type { WithRandom } from '../random.ts';
import type { Seat } from '../seat.ts';

/** One signal, and who pressed when. */
export interface Bout {
  /** Milliseconds since the start of the round; a press before belongs to the bout before. */
  readonly beganAtMs: number;
  /** On the same clock. */
  readonly signalAtMs: number;
  /** When each pressed first in this bout. */
  readonly presses: Record<Seat, number>;
}

export interface DuelState extends WithRandom, WithPace {
  /** Steps since the start. */
  step: number;
  readonly seats: readonly Seat[];
  bout: Bout;
  /** Bouts that are decided, with the winner (undefined: none) and the reaction time, milliseconds. */
  readonly decided: { readonly winner?: Seat; readonly reactionMs?: number }[];
}
