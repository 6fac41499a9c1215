/** Hertz. */
const MIN_RATE_HZ = 1;
/** A module is sent a few more pictures than it looks at, so that it never waits for one. */
const HEADROOM = 1.15;
/** Share of the pictures that may be replaced by newer ones before fewer are sent. */
const MAX_REPLACED = 0.15;

/**
 * The rate at which pictures are sent next: fewer when the module looks at fewer, more again when it keeps up.
 *
 * @param wantedHz what is wanted at most
 * @param sentHz what was sent, measured
 * @param seenHz what the module looked at, measured; `undefined` while it looks at none
 */
export function adaptRate(
  currentHz: number,
  wantedHz: number,
  sentHz: number | undefined,
  seenHz: number | undefined,
): number {
  if (sentHz === undefined || seenHz === undefined) return currentHz;
  const isTooMuch = seenHz < sentHz * (1 - MAX_REPLACED);
  const next = isTooMuch ? seenHz * HEADROOM : currentHz * HEADROOM;
  return Math.min(wantedHz, Math.max(MIN_RATE_HZ, next));
}
