import type { Cancel, Clock } from '@ubii/timing';
import type { ResourceUsage, UsageMeasurement } from '../ports/resource-usage.ts';

/** Interval of the master's self-monitoring, milliseconds. [EX-45] */
export const LOOK_INTERVAL_MS = 1_000;

const NOTHING: UsageMeasurement = { cpuPercent: 0, busyPercent: 0, delayMs: 0 };

/** Resources that the master uses, measured every second. */
export class Load {
  readonly #usage: ResourceUsage;
  readonly #clock: Clock;
  readonly #onLook: (load: Load, seconds: number) => void;
  readonly #cancel: Cancel;
  #latest = NOTHING;
  #measuredMs: number;

  /** @param onLook Called after each measurement, with the seconds since the one before. */
  constructor(clock: Clock, usage: ResourceUsage, onLook: (load: Load, seconds: number) => void) {
    this.#clock = clock;
    this.#usage = usage;
    this.#onLook = onLook;
    this.#measuredMs = clock.monotonicMs();
    usage.measure();
    this.#cancel = clock.every(LOOK_INTERVAL_MS, () => this.#look());
  }

  /** Over the last second; zeros before the first has passed. */
  get latest(): UsageMeasurement {
    return this.#latest;
  }

  get memoryBytes(): number {
    return this.#usage.memoryBytes();
  }

  get processors(): number {
    return this.#usage.processors;
  }

  close(): void {
    this.#cancel();
  }

  #look(): void {
    const nowMs = this.#clock.monotonicMs();
    const seconds = (nowMs - this.#measuredMs) / 1000;
    if (seconds <= 0) return;
    this.#measuredMs = nowMs;
    this.#latest = this.#usage.measure();
    this.#onLook(this, seconds);
  }
}
