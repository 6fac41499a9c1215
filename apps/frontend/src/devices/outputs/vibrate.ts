/** Longest vibration, milliseconds: an error in a session must not keep a phone vibrating. */
const LONGEST_MS = 5000;

/** Whether this device can vibrate; iPhones and computers cannot. */
export function canVibrate(): boolean {
  return 'vibrate' in navigator;
}

/**
 * @param durationMs 0 stops
 * @returns false when it did not vibrate: not supported, or no user interaction yet
 */
export function vibrate(durationMs: number): boolean {
  if (!canVibrate() || Number.isNaN(durationMs)) return false;
  return navigator.vibrate(Math.min(Math.max(durationMs, 0), LONGEST_MS));
}
