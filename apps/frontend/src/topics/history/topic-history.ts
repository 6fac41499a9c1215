import type { DataFormat, TopicRecord } from '@ubii/proto';
import { formatValue } from '../values/format-value.ts';
import { seriesOf, type ValueSeries } from '../values/value-series.ts';
import { EVENT_FORMATS, EventLog } from '../viewers/events/event-log.ts';
import { SampleClock } from './sample-clock.ts';
import { SeriesRing } from './series-ring.ts';

/** Records listed. */
export const MAX_LINES = 200;

/** A record as the list shows it. Pictures and long texts are not kept, only their one line. */
export interface RecordLine {
  /** Counts up from 1 with every record of the topic seen here. */
  readonly number: number;
  /** When the value was taken, by the publisher's clock if it says so: milliseconds since the Unix epoch. */
  readonly timeMs: number;
  /** Since the record before, by the same clock, milliseconds; `undefined` for the first. */
  readonly deltaMs: number | undefined;
  /** The numbers of the value, where it has some. */
  readonly numbers: readonly number[] | undefined;
  readonly text: string;
}

/** What has come on one topic since it was opened. Bounded: the newest value, `MAX_LINES` lines, `MAX_POINTS` points. */
export class TopicHistory {
  readonly #clock = new SampleClock();
  #format: DataFormat | undefined;
  #series: ValueSeries | undefined;
  #ring: SeriesRing | undefined;
  #events: EventLog | undefined;
  #latest: TopicRecord | undefined;
  #latestLocalMs = 0;
  /** Oldest first; up to twice what is listed, so that making room is rare. */
  #lines: RecordLine[] = [];
  #count = 0;
  #before: { readonly timestampMs: number | undefined; readonly arrivalMs: number } | undefined;

  get latest(): TopicRecord | undefined {
    return this.#latest;
  }

  /** When the newest value was taken, this machine's clock. */
  get latestLocalMs(): number {
    return this.#latestLocalMs;
  }

  /** Records since the topic was opened. */
  get count(): number {
    return this.#count;
  }

  /** The newest records, newest first, up to `MAX_LINES`. */
  lines(): RecordLine[] {
    return this.#lines.slice(-MAX_LINES).reverse();
  }

  /** How the values are drawn over time; `undefined` when they are not numbers. */
  get series(): ValueSeries | undefined {
    return this.#series;
  }

  /** The points, by this machine's clock. */
  get points(): SeriesRing | undefined {
    return this.#ring;
  }

  /** What happened, for formats of which every record counts; `undefined` for others. */
  get events(): EventLog | undefined {
    return this.#events;
  }

  /** @param arrivalMs this machine's clock: milliseconds since the Unix epoch */
  add(record: TopicRecord, arrivalMs: number): void {
    if (record.format !== this.#format) this.#begin(record.format);
    const numbers = this.#series?.read(record.value as never);
    this.#latest = record;
    this.#latestLocalMs = this.#clock.toLocalMs(record.timestampMs, arrivalMs);
    this.#events?.add(record, this.#latestLocalMs);
    if (numbers) this.#ring!.push(this.#latestLocalMs, numbers);
    this.#count += 1;
    this.#lines.push({
      number: this.#count,
      timeMs: record.timestampMs ?? arrivalMs,
      deltaMs: this.#deltaMs(record.timestampMs, arrivalMs),
      numbers,
      text: formatValue(record.format, record.value as never),
    });
    if (this.#lines.length >= 2 * MAX_LINES) this.#lines.splice(0, MAX_LINES);
    this.#before = { timestampMs: record.timestampMs, arrivalMs };
  }

  /** Numbers of another format are another story; the list goes on. */
  #begin(format: DataFormat): void {
    this.#format = format;
    this.#series = seriesOf(format);
    this.#events = EVENT_FORMATS.has(format) ? new EventLog() : undefined;
    this.#ring = this.#series && new SeriesRing(this.#series.names.length);
  }

  #deltaMs(timestampMs: number | undefined, arrivalMs: number): number | undefined {
    const before = this.#before;
    if (before === undefined) return undefined;
    if (timestampMs === undefined || before.timestampMs === undefined) {
      return arrivalMs - before.arrivalMs;
    }
    return timestampMs - before.timestampMs;
  }
}
