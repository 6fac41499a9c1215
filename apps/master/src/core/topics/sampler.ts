import type { Cancel, Clock } from '@ubii/timing';
import type { Outbox } from './outbox.ts';
import { isEventField, type Sample, type TopicEntry, type TopicSampler } from './topic-entry.ts';

/** No timer sleeps longer; it looks again. Timers of JavaScript do not go beyond 24 days. */
const MAX_SLEEP_MS = 60_000;

/** A topic of a sampler. */
export class SampledTopic implements Sample {
  readonly entry: TopicEntry;
  readonly sampler: TopicSampler;
  intervalMs = 0;
  dueMs = Number.NEGATIVE_INFINITY;

  constructor(entry: TopicEntry, sampler: TopicSampler) {
    this.entry = entry;
    this.sampler = sampler;
  }

  cancel(): void {
    this.sampler.cancel(this);
  }

  release(): void {
    this.sampler.release(this);
  }
}

/** Dependencies of a sampler. */
export interface SamplerContext {
  readonly clock: Clock;
  /** Brings the targets of a topic up to date, which may cancel samples. */
  readonly refreshTargets: (entry: TopicEntry) => void;
}

/** The sampled topics of one client: their held-back records, and one timer for all. */
export class Sampler implements TopicSampler {
  readonly #outbox: Outbox;
  readonly #context: SamplerContext;
  readonly #isPeers: boolean;
  /** Undefined before the first is held back: most clients sample nothing. */
  #holding: Set<Sample> | undefined = undefined;
  #cancelTimer: Cancel | undefined = undefined;
  #timerDueMs = Number.POSITIVE_INFINITY;
  /** When the first record was delivered: from then on the ticks of every interval count. */
  #firstMs: number | undefined = undefined;

  /** @param isPeers it is of another master, which gets no value that came from a master [CU-11] */
  constructor(outbox: Outbox, context: SamplerContext, isPeers = false) {
    this.#outbox = outbox;
    this.#context = context;
    this.#isPeers = isPeers;
  }

  handleRecord(sample: Sample, nowMs: number): void {
    if (this.#holding?.has(sample) || !this.#outbox.isOpen) return;
    if (nowMs >= sample.dueMs) this.#deliver(sample, nowMs);
    else {
      this.#holding ??= new Set();
      this.#holding.add(sample);
      this.#wakeAt(sample.dueMs, nowMs);
    }
  }

  cancel(sample: Sample): void {
    this.#holding?.delete(sample);
  }

  release(sample: Sample): void {
    if (this.#holding?.delete(sample) === true) this.#deliver(sample, 0);
  }

  withdraw({ entry }: Sample): void {
    this.#outbox.withdraw(entry);
  }

  handleGone(sample: Sample): void {
    this.cancel(sample);
    this.#outbox.handleGone(sample.entry);
  }

  /** The connection is closed: what is held back is queued for replay [TD-33]. */
  close(): void {
    for (const { entry } of this.#holding ?? []) this.#outbox.queueReplay(entry);
    this.discard();
  }

  discard(): void {
    this.#holding = undefined;
    this.#cancelTimer?.();
    this.#cancelTimer = undefined;
    this.#timerDueMs = Number.POSITIVE_INFINITY;
  }

  #deliver(sample: Sample, nowMs: number): void {
    const { entry } = sample;
    if (entry.record === undefined || (this.#isPeers && entry.originId !== undefined)) return;
    sample.dueMs = this.#tickAfter(nowMs, sample.intervalMs);
    this.#outbox.deliver(entry, entry.record, isEventField(entry.valueField));
  }

  /**
   * The next tick of an interval. Topics of one interval share their ticks, so that what a client sees of inputs
   * and outputs is from one moment.
   */
  #tickAfter(nowMs: number, intervalMs: number): number {
    this.#firstMs ??= nowMs;
    // A tick that is due now is over, also when its time was rounded
    const ticks = Math.floor((nowMs - this.#firstMs) / intervalMs + 1e-6) + 1;
    return this.#firstMs + ticks * intervalMs;
  }

  #wakeAt(dueMs: number, nowMs: number): void {
    if (dueMs >= this.#timerDueMs) return;
    this.#cancelTimer?.();
    this.#timerDueMs = dueMs;
    const delayMs = Math.min(Math.max(Math.ceil(dueMs - nowMs), 0), MAX_SLEEP_MS);
    this.#cancelTimer = this.#context.clock.after(delayMs, () => this.#wake());
  }

  #wake(): void {
    this.#cancelTimer = undefined;
    this.#timerDueMs = Number.POSITIVE_INFINITY;
    const nowMs = this.#context.clock.monotonicMs();
    let nextMs = Number.POSITIVE_INFINITY;
    for (const sample of [...(this.#holding ?? [])]) {
      this.#context.refreshTargets(sample.entry);
      if (this.#holding?.has(sample) !== true) continue;
      if (nowMs >= sample.dueMs) {
        this.#holding.delete(sample);
        this.#deliver(sample, nowMs);
      } else nextMs = Math.min(nextMs, sample.dueMs);
    }
    if (nextMs < Number.POSITIVE_INFINITY) this.#wakeAt(nextMs, nowMs);
  }
}
