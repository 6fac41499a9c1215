import type { TimeSample } from './time-sample.ts';

/** Rate of the master's clock relative to the monotonic clock, milliseconds per millisecond. */
export interface Drift {
  readonly rate: number;
  /** The true rate is no further away. */
  readonly uncertainty: number;
}

/** Nothing drifts more: 200 ppm of a bad crystal, and 500 ppm while the master's system corrects its clock. */
const MAX_DRIFT = 700e-6;
/** The rate may change at any time: mostly because the master's system begins to correct its clock. */
const MIN_UNCERTAINTY = 100e-6;
/** Samples with a larger bound than this many times the least say little about the rate. */
const GOOD_BOUND = 2;
/** A line through fewer, or over less time, is none. */
const MIN_GOOD_SAMPLES = 3;
const MIN_SPAN_MS = 20_000;

const UNKNOWN_DRIFT: Drift = { rate: 0, uncertainty: MAX_DRIFT };

/**
 * The drift that samples tell. Each pair of samples bounds the rate, whatever the network did to
 * either of them; within these bounds it is the slope of the line through the good samples. [TS-5]
 * @param samples oldest first
 * @returns the drift, and how many of the newest samples have it: older ones are of another rate
 */
function driftOf(samples: readonly TimeSample[]): { drift: Drift; agreeing: number } {
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

/** Estimate of the master's clock at one moment. */
interface TimeGuess {
  /** Master's clock minus the monotonic clock, milliseconds. */
  readonly offsetMs: number;
  /** The true offset is no further away, milliseconds. */
  readonly errorMs: number;
  /** Milliseconds per millisecond. */
  readonly rate: number;
  /** The sample it stands on: monotonic milliseconds. */
  readonly sampleAtMs: number;
}

/** The offset at a moment comes from the best sample of this time before it, milliseconds. */
const FRESH_MS = 60_000;
/** Of older samples the best of each such time is kept, for the drift, milliseconds. */
const PERIOD_MS = 10_000;
/** Number of kept samples: ten minutes. */
const PERIODS = 60;

/**
 * Offset and drift from samples. A sample bounds the offset whatever the network does, so the one
 * with the shortest round trip counts; what was true then becomes less certain by the uncertainty of
 * the drift as it ages. [TS-4]
 */
export class TimeEstimator {
  /** The last minute, oldest first. */
  #fresh: TimeSample[] = [];
  /** The best sample of each period, oldest first. */
  #best: TimeSample[] = [];
  #drift: Drift = UNKNOWN_DRIFT;
  /** A sample that contradicts all others: a clock was set, or the sample is wrong. */
  #suspect: TimeSample | undefined;

  /** Forgets everything: the clocks have nothing to do with what they were. */
  reset(): void {
    this.#fresh = [];
    this.#best = [];
    this.#drift = UNKNOWN_DRIFT;
    this.#suspect = undefined;
  }

  /** @returns false for a sample that contradicts those before; a second one like it makes all others void [TS-6] */
  add(sample: TimeSample): boolean {
    const guess = this.#guessAt(sample.atMs);
    if (guess !== undefined) {
      const apartMs = Math.abs(sample.offsetMs - guess.offsetMs);
      if (apartMs > guess.errorMs + sample.boundMs) {
        const before = this.#suspect;
        if (before === undefined || !agree(before, sample)) {
          this.#suspect = sample;
          return false;
        }
        this.reset();
        this.#take(before);
      }
    }
    this.#suspect = undefined;
    this.#take(sample);
    return true;
  }

  /** undefined before the first sample. @param nowMs monotonic milliseconds */
  at(nowMs: number): TimeGuess | undefined {
    const guess = this.#guessAt(nowMs);
    const suspect = this.#suspect;
    if (guess === undefined || suspect === undefined) return guess;
    // Until the next sample decides, either may be right.
    const ageMs = Math.abs(nowMs - suspect.atMs);
    const apartMs = Math.abs(suspect.offsetMs - guess.offsetMs);
    const errorMs = Math.max(guess.errorMs, apartMs + suspect.boundMs + MAX_DRIFT * ageMs);
    return { ...guess, errorMs };
  }

  #guessAt(nowMs: number): TimeGuess | undefined {
    const { rate, uncertainty } = this.#drift;
    let best: TimeSample | undefined;
    let leastMs = Infinity;
    for (const sample of this.#fresh) {
      const errorMs = sample.boundMs + uncertainty * Math.abs(nowMs - sample.atMs);
      if (errorMs > leastMs) continue;
      best = sample;
      leastMs = errorMs;
    }
    if (best === undefined) return undefined;
    return {
      offsetMs: best.offsetMs + rate * (nowMs - best.atMs),
      errorMs: leastMs,
      rate,
      sampleAtMs: best.atMs,
    };
  }

  #take(sample: TimeSample): void {
    const oldestMs = sample.atMs - FRESH_MS;
    this.#fresh = this.#fresh.filter(({ atMs }) => atMs >= oldestMs);
    this.#fresh.push(sample);
    const last = this.#best.at(-1);
    if (last === undefined || periodOf(last) !== periodOf(sample)) this.#best.push(sample);
    else if (sample.boundMs <= last.boundMs) this.#best[this.#best.length - 1] = sample;
    else return;
    if (this.#best.length > PERIODS) this.#best.shift();
    const { drift, agreeing } = driftOf(this.#best);
    this.#drift = drift;
    if (agreeing < this.#best.length) this.#best = this.#best.slice(-agreeing);
  }
}

function periodOf({ atMs }: TimeSample): number {
  return Math.floor(atMs / PERIOD_MS);
}

function agree(one: TimeSample, other: TimeSample): boolean {
  const slackMs = one.boundMs + other.boundMs + MAX_DRIFT * Math.abs(other.atMs - one.atMs);
  return Math.abs(one.offsetMs - other.offsetMs) <= slackMs;
}
