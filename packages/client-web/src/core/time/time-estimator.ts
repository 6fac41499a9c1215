import { MAX_DRIFT, UNKNOWN_DRIFT, driftOf } from './drift.ts';
import type { Drift } from './drift.ts';
import type { TimeSample } from './time-sample.ts';

/** Estimate of the master's clock at one moment. */
export interface TimeGuess {
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
/** For how many of them: ten minutes. */
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
