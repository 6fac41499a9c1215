import type { StatusSample } from '@ubii/proto';
import type { Cancel, Clock } from '@ubii/timing';
import type { Counters } from './counters.ts';
import type { Load } from './load.ts';

/** [EX-17], milliseconds. */
const SAMPLE_INTERVAL_MS = 2_000;
/** Ten minutes of samples [EX-17]. */
const KEPT_SAMPLES = 300;

/** Looks at the master every two seconds, and keeps what it saw. */
export class Samples {
  readonly #clock: Clock;
  readonly #load: Load;
  readonly #counters: Counters;
  readonly #samples: StatusSample[] = [];
  readonly #cancel: Cancel;
  #recordsIn = 0;
  #recordsOut = 0;
  #takenMs: number;

  constructor(clock: Clock, load: Load, counters: Counters) {
    this.#clock = clock;
    this.#load = load;
    this.#counters = counters;
    this.#takenMs = clock.monotonicMs();
    this.#cancel = clock.every(SAMPLE_INTERVAL_MS, () => this.#take());
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
    this.#samples.push({
      timeMs: this.#clock.nowMs(),
      recordsPerSecond,
      recordsOutPerSecond,
      ...this.#load.latest,
    });
    if (this.#samples.length > KEPT_SAMPLES) this.#samples.shift();
  }
}
