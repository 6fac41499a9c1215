/** Milliseconds: long enough to be felt, short enough not to be in the way of the next. */
export const PRESS_MS = 10;
export const HIT_MS = 60;

/** @returns false where the device cannot: iPhones and computers, or before the first touch of the page */
export function vibrate(durationMs: number): boolean {
  return 'vibrate' in navigator && navigator.vibrate(durationMs);
}
