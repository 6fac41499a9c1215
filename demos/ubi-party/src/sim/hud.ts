import type { Seat } from './seat.ts';

/** Texts on the big screen beside the picture of a round. They come from the game. */
export interface Hud {
  /** The largest words, such as `Lap 2 of 3`. */
  readonly headline: string;
  /** A statement to decide on, with what a step to the left and to the right means. */
  readonly question?: { readonly text: string; readonly left: string; readonly right: string };
  /** A few words behind each name, such as `+0.6 s`. */
  readonly notes: Readonly<Record<Seat, string>>;
  /** Those who are out: their names are dimmed. */
  readonly out: readonly Seat[];
  /** A number that counts down, or counts, and what it is of. */
  readonly corner?: { readonly value: string; readonly label: string };
  /** The newest event, shown for a second and a half. */
  readonly news?: { readonly seat: Seat; readonly sentence: string };
}

/** Display time of a piece of news, steps. */
export const NEWS_STEPS = 96;
