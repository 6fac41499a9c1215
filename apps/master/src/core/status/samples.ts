import type { StatusSample } from '@ubii/proto';
import type { Cancel, Clock } from '../ports/clock.ts';
import type { ResourceUsage } from '../ports/resource-usage.ts';
import type { Counters } from './counters.ts';

/** [EX-17], milliseconds. */
const SAMPLE_INTERVAL_MS = 2_000;
/** Ten minutes of samples [EX-17]. */
const KEPT_SAMPLES = 300;

/** Looks at the master every two seconds, and keeps what it saw. */
export class Samples {
  readonly #clock: Clock;
  readonly #usage: ResourceUsage;
  readonly #counters: Counters;
  readonly #samples: StatusSample[] = [];
  readonly #cancel: Cancel;
  #recordsIn = 0;
  #recordsOut = 0;
  #takenMs: number;
  #cpuPercent = 0;

  constructor(clock: Clock, usage: ResourceUsage, counters: Counters) {
    this.#clock = clock;
    this.#usage = usage;
    this.#counters = counters;
    this.#takenMs = clock.monotonicMs();
    this.#cancel = clock.every(SAMPLE_INTERVAL_MS, () => this.#take());
  }

  /** Share of one core used between the last two samples, percent. */
  get cpuPercent(): number {
    return this.#cpuPercent;
  }

  get memoryBytes(): number {
    return this.#usage.memoryBytes();
  }

  /** Samples after this moment, oldest first. */
  since(timeMs: number): StatusSample[] {
    return this.#samples.filter((sample) => sample.timeMs > timeMs);
  }

  close(): void {
    this.#cancel();
  }

  #take(): void {
    const nowMs = this.#clock.monotonicMs();
    const { recordsIn, recordsOut } = this.#counters;
    const seconds = (nowMs - this.#takenMs) / 1000;
    const perSecond = (count: number): number => (seconds > 0 ? count / seconds : 0);
    const recordsPerSecond = perSecond(recordsIn - this.#recordsIn);
    const recordsOutPerSecond = perSecond(recordsOut - this.#recordsOut);
    this.#takenMs = nowMs;
    this.#recordsIn = recordsIn;
    this.#recordsOut = recordsOut;
    this.#cpuPercent = this.#usage.cpuPercent();
    this.#samples.push({
      timeMs: this.#clock.nowMs(),
      recordsPerSecond,
      recordsOutPerSecond,
      cpuPercent: this.#cpuPercent,
      busyPercent: 0,
      delayMs: 0,
    });
    if (this.#samples.length > KEPT_SAMPLES) this.#samples.shift();
  }
}
