import type { TimeSample } from './time-sample.ts';

/** Rate of the master's clock relative to the monotonic clock, milliseconds per millisecond. */
export interface Drift {
  readonly rate: number;
  /** The true rate is no further away. */
  readonly uncertainty: number;
}

/** Nothing drifts more: 200 ppm of a bad crystal, and 500 ppm while the master's system corrects its clock. */
export const MAX_DRIFT = 700e-6;
/** The rate may change at any time: mostly because the master's system begins to correct its clock. */
const MIN_UNCERTAINTY = 100e-6;
/** Samples with a larger bound than this many times the least say little about the rate. */
const GOOD_BOUND = 2;
/** A line through fewer, or over less time, is none. */
const MIN_GOOD_SAMPLES = 3;
const MIN_SPAN_MS = 20_000;

export const UNKNOWN_DRIFT: Drift = { rate: 0, uncertainty: MAX_DRIFT };

/**
 * The drift that samples tell. Each pair of samples bounds the rate, whatever the network did to
 * either of them; within these bounds it is the slope of the line through the good samples. [TS-5]
 * @param samples oldest first
 * @returns the drift, and how many of the newest samples have it: older ones are of another rate
 */
export function driftOf(samples: readonly TimeSample[]): { drift: Drift; agreeing: number } {
  let least = -MAX_DRIFT;
  let most = MAX_DRIFT;
  let agreeing = 0;
  for (let older = samples.length - 1; older >= 0; older -= 1, agreeing += 1) {
    let low = least;
    let high = most;
    for (let newer = older + 1; newer < samples.length; newer += 1) {
      const a = samples[older]!;
      const b = samples[newer]!;
      const spanMs = b.atMs - a.atMs;
      if (spanMs <= 0) continue;
      const rise = b.offsetMs - a.offsetMs;
      const slack = a.boundMs + b.boundMs;
      low = Math.max(low, (rise - slack) / spanMs);
      high = Math.min(high, (rise + slack) / spanMs);
    }
    if (low > high) break;
    least = low;
    most = high;
  }
  const slope = slopeOf(samples.slice(samples.length - agreeing)) ?? (least + most) / 2;
  const rate = Math.min(most, Math.max(least, slope));
  const uncertainty = Math.max(most - rate, rate - least, MIN_UNCERTAINTY);
  return { drift: { rate, uncertainty }, agreeing };
}

/** Slope of the weighted least-squares line through the good samples; undefined where there are too few. */
function slopeOf(samples: readonly TimeSample[]): number | undefined {
  const least = Math.min(...samples.map(({ boundMs }) => boundMs));
  const good = samples.filter(({ boundMs }) => boundMs <= GOOD_BOUND * least);
  const [first] = good;
  const last = good.at(-1);
  if (first === undefined || last === undefined || good.length < MIN_GOOD_SAMPLES) return undefined;
  if (last.atMs - first.atMs < MIN_SPAN_MS) return undefined;
  let weights = 0;
  let sumX = 0;
  let sumY = 0;
  let sumXX = 0;
  let sumXY = 0;
  for (const { atMs, offsetMs, boundMs } of good) {
    // From the first one: epoch milliseconds squared do not fit a number.
    const x = atMs - first.atMs;
    const y = offsetMs - first.offsetMs;
    const weight = 1 / boundMs ** 2;
    weights += weight;
    sumX += weight * x;
    sumY += weight * y;
    sumXX += weight * x * x;
    sumXY += weight * x * y;
  }
  const spread = weights * sumXX - sumX ** 2;
  return spread > 0 ? (weights * sumXY - sumX * sumY) / spread : undefined;
}
