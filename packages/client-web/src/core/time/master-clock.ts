import type { Clock } from '@ubii/timing';
import type { ErrorHandler } from '../ports/error-handler.ts';
import { Listeners } from '../callbacks/listeners.ts';
import type { Unsubscribe } from '../callbacks/unsubscribe.ts';
import { readClocks, wallAheadMs, type ClockReading } from './clock-reading.ts';
import type { MasterTime, MasterTimeEstimate } from './master-time.ts';
import { TimeEstimator } from './time-estimator.ts';
import { sampleOf, type TimeExchange } from './time-sample.ts';

/** Steps in which clocks of browsers and of Node are known to go on, milliseconds, coarsest first. */
const GRAINS_MS = [1, 0.1, 0.02] as const;
const FINEST_MS = 0.005;
/** Fractions of a number this large are rounded. */
const ROUNDING = 1e-3;

/** Finds the resolution of a clock from its readings: browsers give pages coarse clocks. */
class ClockGrain {
  #index = 0;

  /** The step, milliseconds. */
  get grainMs(): number {
    return GRAINS_MS[this.#index] ?? FINEST_MS;
  }

  add(readingMs: number): void {
    for (let grainMs = GRAINS_MS[this.#index]; grainMs !== undefined;) {
      const steps = readingMs / grainMs;
      if (Math.abs(steps - Math.round(steps)) < ROUNDING) return;
      this.#index += 1;
      grainMs = GRAINS_MS[this.#index];
    }
  }
}

/** The clocks may part by this much between two readings, and by this share of the time between them. [TS-7] */
const JUMP_MS = 20;
const JUMP_SHARE = 0.001;

/**
 * Keeps the master's time on the monotonic clock: the wall clock of a machine may be set at any
 * moment. That clock stands still while most machines sleep, which shows in the other one going on.
 */
export class MasterClock implements MasterTime {
  readonly #clock: Clock;
  readonly #measureAgain: () => void;
  readonly #estimator = new TimeEstimator();
  readonly #grain = new ClockGrain();
  readonly #masterGrain = new ClockGrain();
  readonly #listeners: Listeners<MasterTimeEstimate | undefined>;
  #last: ClockReading | undefined;
  /** Offset until the next measurement: added to one of the two clocks, milliseconds. */
  #makeshift: { readonly clock: keyof ClockReading; readonly offsetMs: number } = {
    clock: 'wallMs',
    offsetMs: 0,
  };
  #isNewLink = false;

  /** @param measureAgain requests measurements; called when the estimate is no longer valid */
  constructor(clock: Clock, measureAgain: () => void, onError: ErrorHandler) {
    this.#clock = clock;
    this.#measureAgain = measureAgain;
    this.#listeners = new Listeners(onError);
  }

  nowMs(): number {
    const reading = this.#read();
    const guess = this.#estimator.at(reading.monotonicMs);
    if (guess !== undefined) return reading.monotonicMs + guess.offsetMs;
    return reading[this.#makeshift.clock] + this.#makeshift.offsetMs;
  }

  get estimate(): MasterTimeEstimate | undefined {
    return this.#estimateAt(this.#read());
  }

  onEstimate(fn: (estimate: MasterTimeEstimate | undefined) => void): Unsubscribe {
    return this.#listeners.add(fn);
  }

  /** There is a new link: its first exchange may come from another master. [TS-8] */
  handleLink(): void {
    this.#isNewLink = true;
  }

  handleExchange(exchange: TimeExchange): void {
    const { sent, received, masterReceivedMs, masterSentMs } = exchange;
    for (const reading of [sent, received]) this.#grain.add(reading.monotonicMs);
    for (const readingMs of [masterReceivedMs, masterSentMs]) this.#masterGrain.add(readingMs);
    this.#watch(received);
    const sample = sampleOf(exchange, this.#grain.grainMs + this.#masterGrain.grainMs);
    if (sample === undefined) return;
    if (this.#isNewLink) this.#estimator.reset();
    this.#isNewLink = false;
    if (!this.#estimator.add(sample)) this.#measureAgain(); // [TS-6]
    this.#listeners.emit(this.#estimateAt(received));
  }

  #estimateAt(reading: ClockReading): MasterTimeEstimate | undefined {
    const guess = this.#estimator.at(reading.monotonicMs);
    if (guess === undefined) return undefined;
    const { offsetMs, errorMs, rate, sampleAtMs } = guess;
    return {
      offsetMs: reading.monotonicMs + offsetMs - reading.wallMs,
      driftPpm: rate * 1e6,
      errorMs,
      measuredAt: sampleAtMs + offsetMs,
    };
  }

  #read(): ClockReading {
    const reading = readClocks(this.#clock);
    this.#watch(reading);
    return reading;
  }

  /** [TS-7] */
  #watch(reading: ClockReading): void {
    const last = this.#last;
    this.#last = reading;
    if (last === undefined) return;
    const aheadMs = wallAheadMs(last, reading);
    const passedMs = Math.max(0, reading.monotonicMs - last.monotonicMs);
    if (Math.abs(aheadMs) <= JUMP_MS + JUMP_SHARE * passedMs) return;
    const guess = this.#estimator.at(last.monotonicMs);
    if (guess === undefined) {
      this.#measureAgain();
      return;
    }
    // A wall clock that is ahead went on through a sleep, or was set: then the next measurement corrects
    // it. No sleep sets it back.
    const slept = aheadMs > 0;
    this.#makeshift = {
      clock: slept ? 'wallMs' : 'monotonicMs',
      offsetMs: guess.offsetMs + (slept ? last.monotonicMs - last.wallMs : 0),
    };
    this.#estimator.reset();
    this.#listeners.emit(undefined);
    this.#measureAgain();
  }
}
