/** Longer ones are cut, milliseconds: a mistake in a session must not keep a phone buzzing. */
const LONGEST_MS = 5000;

/** Whether this device can vibrate at all; iPhones and computers cannot. */
export function canVibrate(): boolean {
  return 'vibrate' in navigator;
}

/**
 * @param durationMs 0 stops
 * @returns false when the device did not: it cannot, or the user has not touched the page yet
 */
export function vibrate(durationMs: number): boolean {
  if (!canVibrate() || Number.isNaN(durationMs)) return false;
  return navigator.vibrate(Math.min(Math.max(durationMs, 0), LONGEST_MS));
}
