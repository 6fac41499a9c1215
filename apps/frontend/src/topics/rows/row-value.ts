import type { TopicRecord } from '@ubii/proto';
import { formatValue } from '../values/format-value.ts';
import { sparkNumbers } from '../values/value-series.ts';
import { NO_SPARK, SPARK_SAMPLES, Sparkline, type SparkLine } from './sparkline.ts';

/** Below this rate a line over 5 s says nothing, Hz. */
const MIN_SPARK_HZ = 0.5;
/** An update after this much silence is news and flashes, milliseconds. */
const NEWS_MS = 400;
/** A topic that never rests flashes this often: that it lives, its numbers show. */
const REMINDER_MS = 4000;
const SPREAD = 16;

/** What a row shows of its topic's newest record. Kept for rows that are or lately were on screen. */
export class RowValue {
  #record: TopicRecord | undefined;
  #text: string | undefined;
  #numbers: readonly number[] = [];
  readonly #sparkline = new Sparkline();
  #spark: SparkLine | undefined;
  /** Samples since the last one that was not a gap. */
  #gap = SPARK_SAMPLES;
  #records: number;
  #flashes = 0;
  #flashedMs = 0;
  /** When the count of records grew last; `undefined` before the first sample. */
  #grownMs: number | undefined;

  /** @param records counted for the topic so far */
  constructor(records: number) {
    this.#records = records;
  }

  /** The newest record. */
  get record(): TopicRecord | undefined {
    return this.#record;
  }

  /** The newest value in one line; `undefined` before the first. */
  get text(): string | undefined {
    const record = this.#record;
    if (record === undefined) return undefined;
    return (this.#text ??= formatValue(record.format, record.value as never));
  }

  /** The last 5 s. */
  get spark(): SparkLine {
    return (this.#spark ??=
      this.#gap >= SPARK_SAMPLES ? NO_SPARK : this.#sparkline.line(this.#numbers.length === 0));
  }

  /** Counts up with every flash; 0 for none yet. */
  get flashes(): number {
    return this.#flashes;
  }

  handleRecord(record: TopicRecord): void {
    this.#record = record;
    this.#text = undefined;
    this.#numbers = sparkNumbers(record.format, record.value);
  }

  /** The topic holds no value any more; the last one would be a lie. */
  clear(): void {
    this.#record = undefined;
    this.#text = undefined;
    this.#sparkline.clear();
    this.#spark = NO_SPARK;
    this.#gap = SPARK_SAMPLES;
  }

  /**
   * Notes how far the topic has come; called about 8 times a second.
   * @param counted records of the topic so far, and how many a second
   * @param nowMs any clock
   */
  sample(
    counted: { readonly records: number; readonly hz: number | undefined },
    nowMs: number,
  ): void {
    this.#noteGrowth(counted.records, nowMs);
    const isAlive = counted.hz !== undefined && counted.hz >= MIN_SPARK_HZ;
    if (this.#record === undefined || (!isAlive && this.#gap >= SPARK_SAMPLES)) return;
    this.#gap = isAlive ? 0 : this.#gap + 1;
    const activity = isAlive ? [counted.hz!] : undefined;
    this.#sparkline.add(isAlive && this.#numbers.length > 0 ? this.#numbers : activity);
    this.#spark = undefined;
  }

  #noteGrowth(records: number, nowMs: number): void {
    if (this.#grownMs === undefined) {
      // Coming on screen is no news, and the reminders of many rows are spread over their time.
      this.#grownMs = nowMs;
      this.#flashedMs = nowMs - ((records % SPREAD) / SPREAD) * REMINDER_MS;
    }
    if (records === this.#records) return;
    const isNews = nowMs - this.#grownMs >= NEWS_MS || nowMs - this.#flashedMs >= REMINDER_MS;
    if (isNews && records > this.#records) {
      this.#flashes += 1;
      this.#flashedMs = nowMs;
    }
    this.#records = records;
    this.#grownMs = nowMs;
  }
}
