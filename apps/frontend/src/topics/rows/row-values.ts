import type { TopicRecord } from '@ubii/proto';
import type { LivePattern } from '../../connection/live/topic-source.ts';
import type { TopicRate } from '../../connection/topic-rates.ts';
import { RowValue } from './row-value.ts';

/** Highest update rate that can be read in a row, Hz. */
const ROW_RATE_HZ = 8;
/** Size from which values (pictures) are requested less often: a row shows only their size. */
const LARGE_BYTES = 16_384;
const LARGE_RATE_HZ = 1;
/** Most invisible rows that keep their last value, so that scrolling back shows no gaps. */
const MAX_KEPT = 256;

interface Shown {
  /** `undefined` while the topic is missing in the master's statistics. */
  rate: TopicRate | undefined;
  /** Whether the statistics say that the topic has a value. */
  hasValue: boolean;
  /** A record arrived after the last statistics, which may be older. */
  isFresh: boolean;
}

const hasValue = (rate: TopicRate | undefined): boolean =>
  rate !== undefined && rate.statistic.dataFormat !== '';

/** Newest values of the visible rows; subscriptions follow the rows. */
export class RowValues {
  readonly #want: (topics: readonly LivePattern[]) => void;
  readonly #shown = new Map<string, Shown>();
  /** Least recently shown first. */
  readonly #values = new Map<string, RowValue>();
  #isPaused = false;
  #hasFirst = false;
  /** Newest records received during a pause. */
  readonly #waiting = new Map<string, TopicRecord>();
  readonly #largeRateHz: number;
  readonly #newest: (topic: string) => TopicRecord | undefined;

  /**
   * @param want called with the topics to subscribe to from now on
   * @param largeRateHz rate of large values, for callers that show more than their size
   * @param newest record that another view of the page has of a topic, so that both show the same
   */
  constructor(
    want: (topics: readonly LivePattern[]) => void,
    largeRateHz = LARGE_RATE_HZ,
    newest: (topic: string) => TopicRecord | undefined = () => undefined,
  ) {
    this.#want = want;
    this.#newest = newest;
    this.#largeRateHz = largeRateHz;
  }

  get(topic: string): RowValue | undefined {
    return this.#values.get(topic);
  }

  /**
   * Sets the visible rows. A topic without a value is not subscribed to, because the subscription alone would keep it
   * alive. [TD-41]
   */
  show(rates: Iterable<TopicRate>): void {
    const rows = new Map<string, TopicRate>();
    for (const rate of rates) if (hasValue(rate)) rows.set(rate.statistic.topic, rate);
    this.#show(rows);
  }

  /** Sets the visible rows, with or without a value; a first value is shown as soon as it arrives. */
  showNamed(topics: Iterable<string>, rateOf: (topic: string) => TopicRate | undefined): void {
    this.#show(new Map(Array.from(topics, (topic) => [topic, rateOf(topic)])));
  }

  handleRecord(record: TopicRecord): void {
    const shown = this.#shown.get(record.topic);
    const value = this.#values.get(record.topic);
    if (shown === undefined || value === undefined) return;
    shown.isFresh = true;
    const isFirst = value.record === undefined;
    if (this.#isPaused && !isFirst) this.#waiting.set(record.topic, record);
    else if (isFirst || !this.#newest(record.topic)) value.handleRecord(record);
    this.#hasFirst ||= isFirst;
  }

  /** Takes a sample of every visible row. */
  sample(nowMs: number): void {
    if (this.#isPaused) return;
    for (const [topic, { rate }] of this.#shown) {
      const value = this.#values.get(topic);
      const newest = this.#newest(topic);
      if (newest && newest !== value?.record) value?.handleRecord(newest);
      if (rate === undefined) continue;
      value?.sample({ records: rate.statistic.records, hz: rate.hz }, nowMs);
    }
  }

  /** While paused, values stay unchanged; the newest ones are shown afterwards. */
  setPaused(isPaused: boolean): void {
    this.#isPaused = isPaused;
    if (isPaused) return;
    for (const [topic, record] of this.#waiting) this.#values.get(topic)?.handleRecord(record);
    this.#waiting.clear();
  }

  /** Whether a row got its first value since the last call; such rows show it even while paused. */
  takeFirst(): boolean {
    const hasFirst = this.#hasFirst;
    this.#hasFirst = false;
    return hasFirst;
  }

  close(): void {
    this.#shown.clear();
    this.#values.clear();
    this.#waiting.clear();
    this.#want([]);
  }

  #show(rows: ReadonlyMap<string, TopicRate | undefined>): void {
    for (const [topic, { rate }] of this.#shown) {
      if (rows.has(topic)) continue;
      this.#shown.delete(topic);
      if (rate?.statistic.dataFormat === '') this.#values.get(topic)?.clear();
    }
    for (const [topic, rate] of rows) {
      const shown = this.#shown.get(topic);
      if (shown === undefined) this.#add(topic, rate);
      else this.#renew(topic, shown, rate);
    }
    this.#want(Array.from(this.#shown, ([topic, { rate }]) => this.#wish(topic, rate)));
    this.#forget();
  }

  #add(topic: string, rate: TopicRate | undefined): void {
    const value = this.#values.get(topic) ?? new RowValue(rate?.statistic.records ?? 0);
    this.#values.delete(topic);
    this.#values.set(topic, value);
    this.#shown.set(topic, { rate, hasValue: hasValue(rate), isFresh: false });
  }

  /** The value is gone when it disappears from the statistics. */
  #renew(topic: string, shown: Shown, rate: TopicRate | undefined): void {
    shown.rate = rate;
    if (hasValue(rate)) shown.hasValue = true;
    else if (shown.hasValue && !shown.isFresh) {
      shown.hasValue = false;
      this.#values.get(topic)?.clear();
    }
    shown.isFresh = false;
  }

  #wish(topic: string, rate: TopicRate | undefined): LivePattern {
    const isLarge = rate !== undefined && rate.statistic.valueBytes > LARGE_BYTES;
    return { topic, maxRateHz: isLarge ? this.#largeRateHz : ROW_RATE_HZ };
  }

  #forget(): void {
    for (const topic of this.#values.keys()) {
      if (this.#values.size <= MAX_KEPT) return;
      if (!this.#shown.has(topic)) this.#values.delete(topic);
    }
  }
}
