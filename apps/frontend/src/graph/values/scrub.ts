/** Modifier keys while a number is dragged. */
export interface ScrubKeys {
  readonly shiftKey: boolean;
  readonly altKey: boolean;
}

/** Pixels per step. */
const STEP_PX = 3;

/**
 * Step of dragging: between a tenth and a hundredth of the number, so that 0.3 and 300 are both in reach. Shift
 * multiplies by ten, Alt divides by ten.
 */
export function stepOf(value: number, isInteger: boolean, keys: ScrubKeys): number {
  const factor = keys.shiftKey ? 10 : keys.altKey ? 0.1 : 1;
  const size = Math.abs(value) < 1e-9 ? 1 : Math.abs(value);
  const step = 10 ** (Math.floor(Math.log10(size)) - 1) * factor;
  if (isInteger) return Math.max(1, Math.round(step));
  return Math.max(1e-6, Math.min(step, 1e6));
}

/**
 * Returns the number after dragging.
 * @param start initial value
 * @param dx distance to the right, pixels
 */
export function scrubbed(start: number, dx: number, isInteger: boolean, keys: ScrubKeys): number {
  const step = stepOf(start, isInteger, keys);
  return rounded(start + Math.trunc(dx / STEP_PX) * step, step);
}

/** Rounds to the decimals of a step, without artefacts of binary fractions. */
export function rounded(value: number, step: number): number {
  const decimals = Math.max(0, Math.min(9, Math.ceil(-Math.log10(step) - 1e-9)));
  return Number(value.toFixed(decimals));
}
