import type { TopicRecord } from '@ubii/proto';
import { formatValue } from '../values/format-value.ts';
import { Reach } from '../values/reach.ts';
import { sparkNumbers } from '../values/value-series.ts';
import { NO_SPARK, SPARK_SAMPLES, Sparkline, type SparkLine } from './sparkline.ts';

/** Rate below which a chart of 5 s says nothing, Hz. */
const MIN_SPARK_HZ = 0.5;
/** Silence after which an update flashes, milliseconds. */
const NEWS_MS = 400;
/** Interval of flashes for topics that update continuously, milliseconds. */
const REMINDER_MS = 4000;
const SPREAD = 16;

/** Display of a topic's newest record in a row. Kept for rows that are or recently were visible. */
export class RowValue {
  #record: TopicRecord | undefined;
  #text: string | undefined;
  #numbers: readonly number[] = [];
  readonly #reach = new Reach();
  /** Time of the last sample. */
  #sampledMs = 0;
  readonly #sparkline = new Sparkline();
  #spark: SparkLine | undefined;
  /** Number of consecutive samples that were gaps. */
  #gap = SPARK_SAMPLES;
  #records: number;
  #flashes = 0;
  #flashedMs = 0;
  /** Time at which the record count last grew; `undefined` before the first sample. */
  #grownMs: number | undefined;

  /** @param records record count of the topic */
  constructor(records: number) {
    this.#records = records;
  }

  /** The newest record. */
  get record(): TopicRecord | undefined {
    return this.#record;
  }

  /** Newest value in one line; `undefined` before the first. */
  get text(): string | undefined {
    const record = this.#record;
    if (record === undefined) return undefined;
    return (this.#text ??= formatValue(record.format, record.value as never, this.#reach.value));
  }

  /** Chart of the last 5 s. */
  get spark(): SparkLine {
    return (this.#spark ??=
      this.#gap >= SPARK_SAMPLES ? NO_SPARK : this.#sparkline.line(this.#numbers.length === 0));
  }

  /** Number of flashes so far. */
  get flashes(): number {
    return this.#flashes;
  }

  handleRecord(record: TopicRecord): void {
    this.#record = record;
    this.#text = undefined;
    this.#numbers = sparkNumbers(record.format, record.value);
    this.#reach.add(this.#numbers, this.#sampledMs);
  }

  /** The topic no longer has a value: remove the last one. */
  clear(): void {
    this.#record = undefined;
    this.#text = undefined;
    this.#sparkline.clear();
    this.#spark = NO_SPARK;
    this.#gap = SPARK_SAMPLES;
  }

  /**
   * Takes a sample of the statistics; called about 8 times a second.
   * @param counted record count and rate of the topic
   * @param nowMs of any clock
   */
  sample(
    counted: { readonly records: number; readonly hz: number | undefined },
    nowMs: number,
  ): void {
    this.#sampledMs = nowMs;
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
      // Becoming visible does not flash, and the flashes of many rows are spread over the interval.
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
