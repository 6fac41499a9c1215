import type { TopicRecord } from '@ubii/proto';
import type { TopicRate } from '../../connection/topic-rates.ts';
import { RowValue } from './row-value.ts';

/** Subscribes to one topic at a limited rate; returns how to end it. */
export type SubscribeRow = (
  topic: string,
  maxRateHz: number,
  onRecord: (record: TopicRecord) => void,
) => () => void;

/** How often a row can be read, Hz. */
const ROW_RATE_HZ = 8;
/** Large values (pictures) come less often: a row shows only their size. */
const LARGE_BYTES = 16_384;
const LARGE_RATE_HZ = 1;
/** Rows that left the screen and keep their last value, so that scrolling back shows no holes. */
const MAX_KEPT = 256;

interface Shown {
  readonly rate: TopicRate;
  readonly unsubscribe: () => void;
}

/**
 * The newest values of the rows on screen, and of no others: subscriptions come and go with the rows.
 * A topic without a value is not subscribed to, because the subscription alone would keep it alive.
 */
export class RowValues {
  readonly #subscribe: SubscribeRow;
  readonly #shown = new Map<string, Shown>();
  /** Least lately shown first. */
  readonly #values = new Map<string, RowValue>();
  #isPaused = false;
  #hasFirst = false;
  /** Newest records that came during a pause. */
  readonly #waiting = new Map<string, TopicRecord>();
  readonly #largeRateHz: number;

  /** @param largeRateHz how often large values come, for those who show more of them than their size */
  constructor(subscribe: SubscribeRow, largeRateHz = LARGE_RATE_HZ) {
    this.#subscribe = subscribe;
    this.#largeRateHz = largeRateHz;
  }

  get(topic: string): RowValue | undefined {
    return this.#values.get(topic);
  }

  /** Makes these the rows on screen. */
  show(rates: Iterable<TopicRate>): void {
    const wanted = new Map<string, TopicRate>();
    for (const rate of rates) {
      if (rate.statistic.dataFormat !== '') wanted.set(rate.statistic.topic, rate);
    }
    for (const [topic, { rate, unsubscribe }] of this.#shown) {
      if (wanted.get(topic) === rate) continue;
      unsubscribe();
      this.#shown.delete(topic);
      if (rate.statistic.dataFormat === '') this.#values.get(topic)?.clear();
    }
    for (const [topic, rate] of wanted) if (!this.#shown.has(topic)) this.#add(topic, rate);
    this.#forget();
  }

  /** Takes a sample of every row on screen. */
  sample(nowMs: number): void {
    if (this.#isPaused) return;
    for (const [topic, { rate }] of this.#shown) {
      const { statistic, hz } = rate;
      this.#values.get(topic)?.sample({ records: statistic.records, hz }, nowMs);
    }
  }

  /** Values stand still while paused; what comes meanwhile is shown afterwards. */
  setPaused(isPaused: boolean): void {
    this.#isPaused = isPaused;
    if (isPaused) return;
    for (const [topic, record] of this.#waiting) this.#values.get(topic)?.handleRecord(record);
    this.#waiting.clear();
  }

  /** Whether a row got its first value since this was asked last; such a row shows it even while paused. */
  takeFirst(): boolean {
    const hasFirst = this.#hasFirst;
    this.#hasFirst = false;
    return hasFirst;
  }

  close(): void {
    for (const { unsubscribe } of this.#shown.values()) unsubscribe();
    this.#shown.clear();
    this.#values.clear();
    this.#waiting.clear();
  }

  #add(topic: string, rate: TopicRate): void {
    const value = this.#values.get(topic) ?? new RowValue(rate.statistic.records);
    this.#values.delete(topic);
    this.#values.set(topic, value);
    const maxRateHz = rate.statistic.valueBytes > LARGE_BYTES ? this.#largeRateHz : ROW_RATE_HZ;
    const unsubscribe = this.#subscribe(topic, maxRateHz, (record) => {
      const isFirst = value.record === undefined;
      if (this.#isPaused && !isFirst) this.#waiting.set(topic, record);
      else value.handleRecord(record);
      this.#hasFirst ||= isFirst;
    });
    this.#shown.set(topic, { rate, unsubscribe });
  }

  #forget(): void {
    for (const topic of this.#values.keys()) {
      if (this.#values.size <= MAX_KEPT) return;
      if (!this.#shown.has(topic)) this.#values.delete(topic);
    }
  }
}
