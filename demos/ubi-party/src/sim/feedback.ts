/**
 * State of the round for one player, sent to the phone. The texts come from the game, so that phones need no knowledge
 * of it.
 */
export interface Feedback {
  /** In the running table, from 1. */
  readonly place: number;
  /** Number of players. */
  readonly of: number;
  /** The largest words on the phone, such as `Lap 2 of 3`; at most 16 characters. */
  readonly headline: string;
  /** One sentence below it. */
  readonly sentence: string;
  /** Progress to the goal, 0 to 1: the ring around the token. */
  readonly progress: number;
  /** Level of the gauge on the pad, 0 to 1: stored boost, charge of a dash. */
  readonly gauge: number;
  /** Whole seconds, where the gauge is time that is left: the pad says them. */
  readonly secondsLeft?: number;
  /** The button does something now. */
  readonly isReady: boolean;
  /** Has nothing to steer any more in this round. */
  readonly isOut: boolean;
  /** The step of the newest hit, 0 for none: the phone vibrates when it changes. */
  readonly hitAt: number;
  /** The player's current question, in games with answers. */
  readonly question?: Question;
}

/** A question to the player. Times are milliseconds since the start of the round on the master's clock. */
export interface Question {
  /** The text of a right answer. */
  readonly text: string;
  /** For people, such as `a cup`. */
  readonly name: string;
  /** Of a right answer, at least. */
  readonly leastScore: number;
  readonly beganAtMs: number;
  readonly endsAtMs: number;
  /** An answer before this does not count. */
  readonly opensAtMs: number;
  /** Reward of a right answer at this moment, such as `3rd would be +1`. */
  readonly prize: string;
}

/** Input elements that the phone shows for a game. */
export interface Controller {
  /** wheel: left and right, by tilting or with the thumb; stick: all directions; none: only the button; camera: photos. */
  readonly steering: 'wheel' | 'stick' | 'none' | 'camera';
  /** On the button. */
  readonly button: string;
  /** A held button charges, letting it go acts. */
  readonly isHeld: boolean;
}

/** The place of a seat in a table, from 1. */
export function placeOf(places: readonly (readonly number[])[], seat: number): number {
  let before = 0;
  for (const seats of places) {
    if (seats.includes(seat)) return before + 1;
    before += seats.length;
  }
  return before + 1;
}
