import type { Seat } from '../sim/index.ts';
import type { PhoneDelay } from './round.ts';

/** Of a phone that was not measured yet: most lines of a room are faster. */
export const UNKNOWN_DELAY: PhoneDelay = { leastMs: 0, mostMs: 100 };

/** The time that a phone sent, and the time that counts; both milliseconds since the Unix epoch. */
export interface JudgedTime {
  readonly claimedMs: number;
  readonly judgedMs: number;
}

/**
 * When something happened: what the phone says, as far as its arrival allows. All times are of the master's clock,
 * milliseconds.
 *
 * @param arrivedMs when it was here
 * @param delay what the way of this phone takes
 */
export function judgeTime(
  claimedMs: number,
  arrivedMs: number,
  { leastMs, mostMs }: PhoneDelay,
): number {
  return Math.min(arrivedMs - leastMs, Math.max(arrivedMs - mostMs, claimedMs));
}

/** Judges what a seat says when it is new, and never again: what is measured later changes nothing. */
export function judgeOnce(
  judged: Record<Seat, JudgedTime>,
  seat: Seat,
  claimedMs: number,
  arrivedMs: number,
  delay: PhoneDelay = UNKNOWN_DELAY,
): { readonly judgedMs: number; readonly isNew: boolean } {
  const known = judged[seat];
  if (known?.claimedMs === claimedMs) return { judgedMs: known.judgedMs, isNew: false };
  const judgedMs = judgeTime(claimedMs, arrivedMs, delay);
  judged[seat] = { claimedMs, judgedMs };
  return { judgedMs, isNew: true };
}
