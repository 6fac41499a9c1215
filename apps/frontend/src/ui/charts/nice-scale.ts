/** Axis from 0 with round ticks. */
export interface NiceScale {
  readonly max: number;
  /** From 0 to `max`, both included. */
  readonly ticks: readonly number[];
}

/** Smallest maximum, to avoid fractional ticks. */
const LOWEST_MAX = 10;

/**
 * Returns a scale with two round steps (half and full): 1, 2, 2.5 or 5 times a power of ten.
 * @param highest largest value
 */
export function niceScale(highest: number): NiceScale {
  const half = Math.max(highest, LOWEST_MAX) / 2;
  const power = 10 ** Math.floor(Math.log10(half));
  const step = [1, 2, 2.5, 5, 10]
    .map((factor) => factor * power)
    .find((candidate) => candidate >= half);
  const round = step ?? half;
  return { max: 2 * round, ticks: [0, round, 2 * round] };
}

/** Formats the label of a tick: `500`, `1 k`, `2.5 M`. */
export function formatTick(value: number): string {
  if (value >= 1e6) return `${value / 1e6} M`;
  if (value >= 1e3) return `${value / 1e3} k`;
  return String(value);
}
