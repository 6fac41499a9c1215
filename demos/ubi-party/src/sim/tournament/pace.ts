import type { Game } from '../game.ts';

/** Factors of the times for reading and answering. */
export const PACES = { normal: 1, relaxed: 1.5, long: 2 } as const;
export type Pace = keyof typeof PACES;

/** For people. */
export const PACE_WORDS: Readonly<Record<Pace, string>> = {
  normal: 'Normal',
  relaxed: 'Relaxed ×1.5',
  long: 'Long ×2',
};

export function isPace(value: unknown): value is Pace {
  return typeof value === 'string' && Object.hasOwn(PACES, value);
}

/** Milliseconds at the normal pace. The countdown is the same at every pace: there is nothing to read. */
export const EXPLANATION_MS = 20_000;
export const COUNTDOWN_MS = 3_000;
export const PODIUM_MS = 15_000;

/**
 * Duration of a phase with something to read, milliseconds; undefined for phases without a fixed duration.
 * @param game the one that is explained
 */
export function readingMs(
  phase: string,
  pace: Pace,
  game: Pick<Game<unknown>, 'explanationMs'> | undefined,
): number | undefined {
  if (phase === 'explanation') return (game?.explanationMs ?? EXPLANATION_MS) * PACES[pace];
  return phase === 'podium' ? PODIUM_MS * PACES[pace] : undefined;
}
