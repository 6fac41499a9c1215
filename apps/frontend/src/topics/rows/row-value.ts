import type { TopicRecord } from '@ubii/proto';
import { formatValue } from '../values/format-value.ts';
import { summaryNumber } from '../values/value-series.ts';

/** Samples of a sparkline: 5 s at 8 a second. */
export const SPARK_SAMPLES = 40;
/** Below this rate a line over 5 s says nothing, Hz. */
const MIN_SPARK_HZ = 0.5;
/** An update after this much silence is news and flashes, milliseconds. */
const NEWS_MS = 400;
/** A topic that never rests flashes this often: that it lives, its numbers show. */
const REMINDER_MS = 4000;

/** What a row shows of its topic's newest record. Kept for rows that are or lately were on screen. */
export class RowValue {
  #record: TopicRecord | undefined;
  #text: string | undefined;
  #number: number | undefined;
  #samples: (number | undefined)[] = [];
  #records: number;
  #flashes = 0;
  #flashedMs = -Infinity;
  #grownMs = -Infinity;

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

  /** The last 5 s, oldest first. A new array with every sample. */
  get samples(): readonly (number | undefined)[] {
    return this.#samples;
  }

  /** Counts up with every flash; 0 for none yet. */
  get flashes(): number {
    return this.#flashes;
  }

  handleRecord(record: TopicRecord): void {
    this.#record = record;
    this.#text = undefined;
    this.#number = summaryNumber(record.format, record.value);
  }

  /** The topic holds no value any more; the last one would be a lie. */
  clear(): void {
    this.#record = undefined;
    this.#text = undefined;
    this.#samples = [];
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
    const isAlive = (counted.hz ?? 0) >= MIN_SPARK_HZ;
    const sample = isAlive ? (this.#number ?? counted.hz) : undefined;
    if (sample === undefined && this.#samples.every((other) => other === undefined)) {
      if (this.#samples.length > 0) this.#samples = [];
      return;
    }
    this.#samples = [...this.#samples.slice(1 - SPARK_SAMPLES), sample];
  }

  #noteGrowth(records: number, nowMs: number): void {
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
