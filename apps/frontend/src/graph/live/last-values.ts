import type { TopicRecord } from '@ubii/proto';
import { formatValue } from '../../topics/values/format-value.ts';
import { sparkNumbers } from '../../topics/values/value-series.ts';

/** A value that came by. */
export interface PassedValue {
  /** Counts up from 1. */
  readonly number: number;
  readonly text: string;
  /** When it came, milliseconds of this machine's clock. */
  readonly atMs: number;
}

/** Values kept, and how much time the line over them shows, milliseconds. */
export const MAX_PASSED = 10;
export const SPARK_MS = 2000;
/** Points of the line: more are not seen. */
const MAX_POINTS = 60;

/** The last values of one topic, and their numbers over two seconds. */
export class LastValues {
  #values: PassedValue[] = [];
  #points: { readonly atMs: number; readonly numbers: readonly number[] }[] = [];
  #count = 0;

  /** Records seen so far. */
  get count(): number {
    return this.#count;
  }

  /** Newest first. */
  get values(): readonly PassedValue[] {
    return this.#values;
  }

  /** @param atMs when it came, milliseconds of this machine's clock; in the past for a retained value */
  add(record: TopicRecord, atMs: number): void {
    this.#count += 1;
    const text = formatValue(record.format, record.value as never);
    this.#values = [{ number: this.#count, text, atMs }, ...this.#values].slice(0, MAX_PASSED);
    const numbers = sparkNumbers(record.format, record.value);
    if (numbers.length > 0) this.#points.push({ atMs, numbers });
  }

  /** The number that moved most in the last two seconds, oldest first; empty when there is none. */
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
