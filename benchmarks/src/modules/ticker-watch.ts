import type { EmptyRecord, TopicRecord } from '@ubii/proto';
import { median, percentile } from '../statistics.ts';
import { isTickerSum, TICKER_HERTZ } from './ticker-module.ts';

const INTERVAL_MS = 1000 / TICKER_HERTZ;
const MAX_SENTENCES = 5;

/** Regularity of the runs, over all tickers. */
export interface TickerRegularity {
  readonly runs: number;
  /** Runs that were due and left out. */
  readonly leftOut: number;
  /** Deviation of a run's start from the middle of the ticker's rhythm, computed from its delta times. */
  readonly startP99Ms: number;
  /** Delay of an output relative to the earliest one of the ticker, compared with the rhythm. */
  readonly arrivalP99Ms: number;
}

interface Ticker {
  nextRun: number;
  /** Of each run: when it began, on a clock that began with the first one. */
  readonly startsMs: number[];
  /** Of each run: when its output came, on a clock of this process. */
  readonly arrivalsMs: number[];
}

/** Checks the outputs of tickers, from their first runs on, and measures how regular they are. */
export class TickerWatch {
  readonly faults: string[] = [];
  readonly #tickers: Map<string, Ticker>;
  #isMeasuring = false;

  constructor(topics: readonly string[]) {
    this.#tickers = new Map(
      topics.map((topic) => [topic, { nextRun: 0, startsMs: [], arrivalsMs: [] }]),
    );
  }

  /** True when each of them has run. */
  get haveAllBegun(): boolean {
    return [...this.#tickers.values()].every(({ nextRun }) => nextRun > 0);
  }

  handleRecord({ topic, value }: TopicRecord | EmptyRecord, arrivedMs: number): void {
    const ticker = this.#tickers.get(topic);
    if (ticker === undefined) return this.#report(`a record on ${topic}`);
    const { x: run, y: elapsedMs, z: sum } = value as { x: number; y: number; z: number };
    // The newest value of the time before, sent again to whoever subscribes.
    if (ticker.nextRun === 0 && run !== 0) return;
    if (run !== ticker.nextRun) {
      this.#report(`run ${run} of ${topic} where ${ticker.nextRun} was to come`);
    }
    ticker.nextRun = run + 1;
    if (!isTickerSum(elapsedMs, sum)) this.#report(`a wrong sum of run ${run} of ${topic}`);
    if (!this.#isMeasuring) return;
    ticker.startsMs.push(elapsedMs);
    ticker.arrivalsMs.push(arrivedMs);
  }

  /** Starts counting. */
  start(): void {
    this.#isMeasuring = true;
  }

  stop(): TickerRegularity {
    this.#isMeasuring = false;
    const all = [...this.#tickers.values()].map(regularityOf);
    const p99 = (values: number[]): number =>
      percentile(
        values.sort((a, b) => a - b),
        0.99,
      );
    const startsMs = all.flatMap((ticker) => ticker.startsMs);
    return {
      runs: startsMs.length,
      leftOut: all.reduce((sum, { leftOut }) => sum + leftOut, 0),
      startP99Ms: p99(startsMs),
      arrivalP99Ms: p99(all.flatMap((ticker) => ticker.arrivalsMs)),
    };
  }

  #report(sentence: string): void {
    if (this.faults.length < MAX_SENTENCES) this.faults.push(`unexpected: ${sentence}`);
  }
}

/** Of one ticker: how far each run was from its place, and each output behind the earliest. */
function regularityOf({ startsMs, arrivalsMs }: Ticker) {
  // The first run may have been late itself: where the places are is what most runs say.
  const phaseMs = meanPhaseMs(startsMs);
  const places = startsMs.map((ms) => Math.round((ms - phaseMs) / INTERVAL_MS));
  const offsetsMs = startsMs.map((ms, index) => ms - places[index]! * INTERVAL_MS);
  const middleMs = median(offsetsMs);
  const delaysMs = arrivalsMs.map((ms, index) => ms - places[index]! * INTERVAL_MS);
  const earliestMs = Math.min(...delaysMs);
  return {
    leftOut: startsMs.length === 0 ? 0 : places.at(-1)! - places[0]! + 1 - places.length,
    startsMs: offsetsMs.map((ms) => Math.abs(ms - middleMs)),
    arrivalsMs: delaysMs.map((ms) => ms - earliestMs),
  };
}

/** Mean on the circle that one interval is. */
function meanPhaseMs(startsMs: readonly number[]): number {
  let x = 0;
  let y = 0;
  for (const ms of startsMs) {
    const angle = (2 * Math.PI * ms) / INTERVAL_MS;
    x += Math.cos(angle);
    y += Math.sin(angle);
  }
  return (Math.atan2(y, x) / (2 * Math.PI)) * INTERVAL_MS;
}
