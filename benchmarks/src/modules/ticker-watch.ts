import type { EmptyRecord, TopicRecord } from '@ubii/proto';
import { percentile } from '../statistics.ts';
import { isTickerSum, TICKER_HERTZ } from './ticker-module.ts';

const INTERVAL_MS = 1000 / TICKER_HERTZ;
const MAX_SENTENCES = 5;

/** How late the runs began, milliseconds, over all tickers. */
export interface TickerLateness {
  readonly runs: number;
  /** Runs that were due and left out. */
  readonly leftOut: number;
  /** Between the moment a run was due and the moment it began, as its delta times say. */
  readonly startP99Ms: number;
  /** Between when its output should have arrived, going by the earliest of the ticker, and when it did. */
  readonly arrivalP99Ms: number;
}

interface Ticker {
  nextRun: number;
  leftOut: number;
  /** Of each output: when the run was due, and when it came. */
  readonly dueMs: number[];
  readonly startMs: number[];
  readonly arrivedMs: number[];
  lastSlot: number;
}

/** Checks the outputs of tickers, from their first runs on, and measures how regular they are. */
export class TickerWatch {
  readonly faults: string[] = [];
  readonly #tickers: Map<string, Ticker>;
  #isMeasuring = false;

  constructor(topics: readonly string[]) {
    this.#tickers = new Map(
      topics.map((topic) => [
        topic,
        {
          nextRun: 0,
          leftOut: 0,
          dueMs: [],
          startMs: [],
          arrivedMs: [],
          lastSlot: 0,
        },
      ]),
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
    // Never early by more than a timer is: half an interval tells one moment from the next.
    const slot = Math.floor(elapsedMs / INTERVAL_MS + 0.1);
    if (this.#isMeasuring) {
      ticker.leftOut += ticker.startMs.length > 0 ? slot - ticker.lastSlot - 1 : 0;
      ticker.dueMs.push(slot * INTERVAL_MS);
      ticker.startMs.push(elapsedMs);
      ticker.arrivedMs.push(arrivedMs);
    }
    ticker.lastSlot = slot;
  }

  /** What comes from now on counts. */
  start(): void {
    this.#isMeasuring = true;
  }

  stop(): TickerLateness {
    this.#isMeasuring = false;
    const tickers = [...this.#tickers.values()];
    const lateness = tickers.flatMap(({ dueMs, startMs }) =>
      startMs.map((ms, index) => Math.abs(ms - dueMs[index]!)),
    );
    const arrivals = tickers.flatMap(({ dueMs, arrivedMs }) => {
      const offsets = arrivedMs.map((ms, index) => ms - dueMs[index]!);
      const earliest = Math.min(...offsets);
      return offsets.map((offset) => offset - earliest);
    });
    const p99 = (values: number[]): number =>
      percentile(
        values.sort((a, b) => a - b),
        0.99,
      );
    return {
      runs: lateness.length,
      leftOut: tickers.reduce((sum, { leftOut }) => sum + leftOut, 0),
      startP99Ms: p99(lateness),
      arrivalP99Ms: p99(arrivals),
    };
  }

  #report(sentence: string): void {
    if (this.faults.length < MAX_SENTENCES) this.faults.push(`unexpected: ${sentence}`);
  }
}
