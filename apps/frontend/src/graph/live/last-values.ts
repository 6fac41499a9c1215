import type { TopicRecord } from '@ubii/proto';
import { formatValue } from '../../topics/values/format-value.ts';
import { sparkNumbers } from '../../topics/values/value-series.ts';

/** A received value. */
export interface PassedValue {
  /** Sequence number, from 1. */
  readonly number: number;
  readonly text: string;
  /** Time of arrival, milliseconds of this computer's clock. */
  readonly atMs: number;
}

/** Number of values kept, and time span of their chart, milliseconds. */
export const MAX_PASSED = 10;
export const SPARK_MS = 2000;
/** Most points of the chart; more cannot be distinguished. */
const MAX_POINTS = 60;

/** Last values of a topic, and the course of their numbers over two seconds. */
export class LastValues {
  #values: PassedValue[] = [];
  #points: { readonly atMs: number; readonly numbers: readonly number[] }[] = [];
  #count = 0;

  /** Number of records received. */
  get count(): number {
    return this.#count;
  }

  /** Newest first. */
  get values(): readonly PassedValue[] {
    return this.#values;
  }

  /** @param atMs time of arrival, milliseconds of this computer's clock; in the past for a retained value */
  add(record: TopicRecord, atMs: number): void {
    this.#count += 1;
    const text = formatValue(record.format, record.value as never);
    this.#values = [{ number: this.#count, text, atMs }, ...this.#values].slice(0, MAX_PASSED);
    const numbers = sparkNumbers(record.format, record.value);
    if (numbers.length > 0) this.#points.push({ atMs, numbers });
  }

  /** The number of the value that varied most in the last two seconds, oldest first; empty when there is none. */
  line(nowMs: number): readonly number[] {
    this.#points = this.#points.filter(({ atMs }) => nowMs - atMs <= SPARK_MS);
    const width = Math.max(0, ...this.#points.map(({ numbers }) => numbers.length));
    let best: readonly number[] = [];
    let most = -1;
    for (let at = 0; at < width; at++) {
      const line = this.#points.flatMap(({ numbers }) => numbers[at] ?? []);
      const span = Math.max(...line) - Math.min(...line);
      if (span <= most) continue;
      most = span;
      best = line;
    }
    const step = Math.ceil(best.length / MAX_POINTS);
    return step <= 1 ? best : best.filter((_, index) => index % step === 0);
  }
}
