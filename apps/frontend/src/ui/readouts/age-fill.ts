const FRESH_MS = 10;
const STALE_MS = 5000;

/** How full an age bar is, 1 (up to 10 ms) to 0 (5 s and more), on a log scale. */
export function ageFill(ageMs: number): number {
  if (ageMs <= FRESH_MS) return 1;
  if (ageMs >= STALE_MS) return 0;
  return 1 - Math.log(ageMs / FRESH_MS) / Math.log(STALE_MS / FRESH_MS);
}
