import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

import {
  encodeRecord,
  type Init,
  type ProcessingModule,
  type EmptyRecord,
  type TopicRecord,
} from '@ubii/proto';

import { startBrokerProcess } from '../brokers/broker-process.ts';
import { median, percentile } from '../statistics.ts';

/** Frequency of the ticker module, Hz. */
export const TICKER_HERTZ = 60;

/** Sines it adds up in each run: some microseconds of work. */
const SINES = 50;

/**
 * A module that says which run it is, when the run began on the clock of the first one, and the result
 * of a little work.
 */
export const TICKER_MODULE = {
  name: 'benchmark-ticker',
  onProcessingStringified: `(deltaTime, inputs, state) => {
    state.run = state.run === undefined ? 0 : state.run + 1;
    state.elapsed = (state.elapsed || 0) + deltaTime;
    let sum = 0;
    for (let i = 0; i < ${SINES}; i += 1) sum += Math.sin(state.elapsed + i);
    return { outputs: { out: { vector3: { x: state.run, y: state.elapsed, z: sum } } } };
  }`,
  outputs: [{ internalName: 'out', messageFormat: 'vector3' }],
  processingMode: { frequency: { hertz: TICKER_HERTZ } },
} satisfies Init<ProcessingModule>;

/** Room for the last digit of a sine: engines differ in it. */
const TOLERANCE = 1e-9;

/** True when `sum` is what the module makes of `elapsedMs`. */
function isTickerSum(elapsedMs: number, sum: number): boolean {
  let expected = 0;
  for (let i = 0; i < SINES; i += 1) expected += Math.sin(elapsedMs + i);
  return Math.abs(sum - expected) < TOLERANCE;
}

/** Values that are replaced; the first one says where they are. */
const PLACEHOLDER = { x: 1.2345678901234567, y: 2, z: 3 };
const TIMESTAMP_MS = 1_750_000_000_000;

/** A process with one bare worker that does what the ticker modules do, see ticker-host.mjs. */
export interface TickerHost {
  readonly pid: number;
  /** Whoever connects gets the records; the tickers run as long as it is connected. */
  readonly url: string;
  stop(): Promise<void>;
}

/** @param topics one for each ticker */
export async function startTickerHost(
  topics: readonly string[],
  profileDir: string | undefined,
): Promise<TickerHost> {
  const folder = await mkdtemp(join(tmpdir(), 'ubii-bench-ticker-'));
  const file = join(folder, 'setting.json');
  await writeFile(
    file,
    JSON.stringify({
      source: TICKER_MODULE.onProcessingStringified,
      hertz: TICKER_HERTZ,
      records: topics.map(template),
    }),
  );
  const process = await startBrokerProcess({
    name: 'ticker-host',
    args: [fileURLToPath(new URL('./ticker-host.mjs', import.meta.url)), file],
    profileDir,
  });
  return {
    pid: process.pid,
    url: String(process.endpoints['url']),
    stop: async () => {
      await process.stop();
      await rm(folder, { recursive: true, force: true });
    },
  };
}

function template(topic: string): { base64: string; offset: number } {
  const bytes = Buffer.from(
    encodeRecord({ topic, format: 'vector3', value: PLACEHOLDER, timestampMs: TIMESTAMP_MS }),
  );
  const double = Buffer.alloc(8);
  double.writeDoubleLE(PLACEHOLDER.x);
  return { base64: bytes.toString('base64'), offset: bytes.indexOf(double) };
}

const INTERVAL_MS = 1000 / TICKER_HERTZ;
const MAX_SENTENCES = 5;

/** Regularity of the runs, over all tickers. */
interface TickerRegularity {
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

  /** True when each module has run. */
  get haveAllBegun(): boolean {
    return [...this.#tickers.values()].every(({ nextRun }) => nextRun > 0);
  }

  handleRecord({ topic, value }: TopicRecord | EmptyRecord, arrivedMs: number): void {
    const ticker = this.#tickers.get(topic);
    if (ticker === undefined) return this.#report(`a record on ${topic}`);
    const { x: run, y: elapsedMs, z: sum } = value as { x: number; y: number; z: number };
    // The newest value of the time before, sent again to new subscribers.
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
