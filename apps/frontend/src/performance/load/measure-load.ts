import { Durations, percentile } from '../measure/durations.ts';
import { NO_FINDINGS, type Findings } from '../measure/findings.ts';
import { Pace } from '../measure/pace.ts';
import { wait, waitUntil, type TestRun } from '../measure/test-run.ts';
import { findKnee, type LoadStep } from './knee.ts';
import { loadFindings } from './load-findings.ts';
import { rampOf, type LoadParameters } from './load-parameters.ts';

/** A connection of the test. */
export interface LoadClient {
  /**
   * Publishes a record of the requested size with this number.
   * @param isLast last record in this turn of the event loop: sends all of them now, as one message
   */
  publish(sequence: number, isLast: boolean): void;
  /** Called for every received record: index of the publishing client, and number of the record. */
  onRecord(fn: (publisher: number, sequence: number) => void): void;
}

export interface LoadWorld {
  readonly clients: readonly LoadClient[];
  /** CPU use of the master, percent of one core; `undefined` when it does not report it. */
  masterCpuPercent(): Promise<number | undefined>;
}

const TICK_MS = 4;
/** Share of a step that is not measured, for warming up. */
const WARM_UP_SHARE = 0.25;
/** Time after which missing records count as lost, milliseconds. */
const GRACE_MS = 1500;
/** Longest timer delay that is compensated at once, milliseconds. */
const MAX_CATCH_UP_MS = 50;
/** Most records per client that are tracked until they arrive. */
const REMEMBERED = 1 << 17;

/** Increases the rate until latency increases or the maximum is reached, and finds the knee. */
export async function measureLoad(
  parameters: LoadParameters,
  world: LoadWorld,
  run: TestRun,
): Promise<Findings> {
  const rates = rampOf(parameters);
  const steps: LoadStep[] = [];
  const traffic = new Traffic(world.clients, run);
  let findings: Findings | undefined;
  for (const [index, wantedHz] of rates.entries()) {
    if (run.signal.aborted) break;
    const report = (part: number): void =>
      run.report({
        share: (index + part) / rates.length,
        words: `${wantedHz} records per second, step ${index + 1} of up to ${rates.length}`,
        findings,
      });
    report(0);
    const step = await measureStep(wantedHz, parameters, world, traffic, run, report);
    // Ignore an aborted step.
    if (step === undefined) break;
    steps.push(step);
    findings = loadFindings(parameters, steps);
    const { firstBad } = findKnee(steps);
    if (firstBad !== undefined && firstBad < steps.length - 1) break;
  }
  return findings ?? NO_FINDINGS;
}

async function measureStep(
  wantedHz: number,
  { secondsPerStep, receivers, clients }: LoadParameters,
  world: LoadWorld,
  traffic: Traffic,
  run: TestRun,
  report: (part: number) => void,
): Promise<LoadStep | undefined> {
  const { clock, signal } = run;
  const stepMs = secondsPerStep * 1000;
  const maxAtOnce = Math.max(1, Math.ceil((wantedHz * MAX_CATCH_UP_MS) / 1000));
  const startedMs = clock.monotonicMs();
  const pace = new Pace(wantedHz, startedMs, maxAtOnce);
  let countsFromMs = startedMs + WARM_UP_SHARE * stepMs;
  let isCounting = false;
  let tickMs = startedMs;
  const lags: number[] = [];
  while (clock.monotonicMs() < startedMs + stepMs) {
    if (signal.aborted) return undefined;
    const nowMs = clock.monotonicMs();
    lags.push(Math.max(0, nowMs - tickMs));
    if (!isCounting && nowMs >= countsFromMs) {
      isCounting = true;
      countsFromMs = nowMs;
      lags.length = 0;
      traffic.startCounting();
    }
    traffic.publish(pace.due(nowMs));
    report((nowMs - startedMs) / stepMs);
    tickMs = clock.monotonicMs() + TICK_MS;
    await wait(TICK_MS, run);
  }
  const seconds = (clock.monotonicMs() - countsFromMs) / 1000;
  traffic.stopCounting();
  const masterCpuPercent = await world.masterCpuPercent().catch(() => undefined);
  const perRecord = receivers === 'all' ? clients : 1;
  const expected = traffic.sent * perRecord;
  await waitUntil(() => traffic.delivered >= expected, GRACE_MS, run);
  const summary = traffic.durations.summary();
  lags.sort((a, b) => a - b);
  return {
    wantedHz,
    sentHz: traffic.sent / seconds,
    deliveredHz: traffic.delivered / seconds,
    lostShare: expected === 0 ? 0 : Math.max(0, 1 - traffic.delivered / expected),
    p50Ms: summary?.p50Ms ?? 0,
    p95Ms: summary?.p95Ms ?? 0,
    p99Ms: summary?.p99Ms ?? 0,
    lagP95Ms: lags.length > 0 ? percentile(lags, 0.95) : 0,
    masterCpuPercent,
  };
}

/** Publishes by turns and measures the latency of received records. */
class Traffic {
  readonly #clients: readonly LoadClient[];
  readonly #run: TestRun;
  readonly #sentMs: readonly Float64Array[];
  readonly #next: number[];
  /** First measured number of each client, and the number after the last. */
  #from: readonly number[] = [];
  #to: readonly number[] = [];
  #turn = 0;
  #isCounting = false;
  durations = new Durations();
  sent = 0;
  delivered = 0;

  constructor(clients: readonly LoadClient[], run: TestRun) {
    this.#clients = clients;
    this.#run = run;
    this.#sentMs = clients.map(() => new Float64Array(REMEMBERED));
    this.#next = clients.map(() => 0);
    for (const client of clients) client.onRecord((from, sequence) => this.#take(from, sequence));
  }

  publish(count: number): void {
    for (let left = count; left > 0; left--) {
      const turn = this.#turn;
      this.#turn = (turn + 1) % this.#clients.length;
      const sequence = this.#next[turn]!++;
      this.#sentMs[turn]![sequence % REMEMBERED] = this.#run.clock.monotonicMs();
      this.#clients[turn]!.publish(sequence, left <= this.#clients.length);
      if (this.#isCounting) this.sent += 1;
    }
  }

  startCounting(): void {
    this.#from = [...this.#next];
    this.#to = this.#next.map(() => Infinity);
    this.durations = new Durations();
    this.sent = 0;
    this.delivered = 0;
    this.#isCounting = true;
  }

  stopCounting(): void {
    this.#to = [...this.#next];
    this.#isCounting = false;
  }

  #take(publisher: number, sequence: number): void {
    const from = this.#from[publisher];
    if (from === undefined || sequence < from || sequence >= this.#to[publisher]!) return;
    const nowMs = this.#run.clock.monotonicMs();
    this.delivered += 1;
    this.durations.add(nowMs - this.#sentMs[publisher]![sequence % REMEMBERED]!, nowMs);
  }
}
