import type { DataFormat, TopicRecord } from '@ubii/proto';
import { formatValue } from '../values/format-value.ts';
import {
  MAX_FIELDS,
  numberFields,
  partsOf,
  readable,
  readNumber,
} from '../values/number-fields.ts';
import { Reach } from '../values/reach.ts';
import { seriesOf, sparkNumbers, type ValueSeries } from '../values/value-series.ts';
import { EVENT_FORMATS, EventLog } from './event-log.ts';
import { DEFAULT_LIMITS, type HistoryLimits } from './history-limits.ts';
import { RecordLog, type KeptRecord } from './record-log.ts';
import { SampleClock } from './sample-clock.ts';
import { SeriesRing, type LinePoints } from './series-ring.ts';

/** Default number of listed records. */
export const MAX_LINES = 200;

/** A record in a list. */
export interface RecordLine {
  /** Sequence number of the record since the topic was opened, from 1; 0 and less for those before. */
  readonly number: number;
  /** Time of measurement, by the publisher's clock if the record has it: epoch milliseconds. */
  readonly timeMs: number;
  /** Time of arrival, this computer's clock. */
  readonly arrivalMs: number;
  /** Time since the previous record, by the same clock, milliseconds; `undefined` for the oldest kept. */
  readonly deltaMs: number | undefined;
  /** Numbers of the value, if it has any. */
  readonly numbers: readonly number[] | undefined;
  readonly text: string;
}

/** Number of records between searches for new fields. */
const LOOK_EVERY = 64;
const NUMBER_BYTES = 8;
/** Most columns: found fields, and others that are requested. */
const MAX_COLUMNS = 2 * MAX_FIELDS;

/** Newest value, records and numbers of a topic since it was opened. Bounded. */
export class TopicHistory {
  readonly #limits: HistoryLimits;
  #clock = new SampleClock();
  #log: RecordLog;
  #format: DataFormat | undefined;
  #series: ValueSeries | undefined;
  #ring: SeriesRing | undefined;
  #events: EventLog | undefined;
  /** Paths of the series of `#ring`, in their order. */
  #fields = new Map<string, { readonly line: number; readonly parts: readonly string[] }>();
  readonly #wanted = new Set<string>();
  #latest: TopicRecord | undefined;
  #latestLocalMs = 0;
  #reach = new Reach();

  constructor(limits: HistoryLimits = DEFAULT_LIMITS, before = 0) {
    this.#limits = limits;
    this.#log = new RecordLog(before);
  }

  get limits(): HistoryLimits {
    return this.#limits;
  }

  get latest(): TopicRecord | undefined {
    return this.#latest;
  }

  /** Time of measurement of the newest value, this computer's clock. */
  get latestLocalMs(): number {
    return this.#latestLocalMs;
  }

  /** Largest magnitude of the recent numbers. */
  get reach(): number {
    return this.#reach.value;
  }

  /** Number of records since the topic was opened. */
  get count(): number {
    return this.#log.count;
  }

  get records(): RecordLog {
    return this.#log;
  }

  /** Estimated memory, bytes. */
  get bytes(): number {
    return this.#log.bytes + (this.#ring?.bytes ?? 0);
  }

  /** The newest records, newest first, up to `MAX_LINES`. */
  lines(): RecordLine[] {
    const lines: RecordLine[] = [];
    const { count, firstNumber } = this.#log;
    for (let number = count; number >= firstNumber && lines.length < MAX_LINES; number--) {
      lines.push(this.lineAt(number)!);
    }
    return lines;
  }

  /** Returns a kept record for display in a list. */
  lineAt(number: number): RecordLine | undefined {
    const kept = this.#log.at(number);
    if (!kept) return undefined;
    const { timestampMs, arrivalMs, format, value } = kept;
    return {
      number,
      timeMs: timestampMs ?? arrivalMs,
      arrivalMs,
      deltaMs: deltaOf(this.#log.at(number - 1), kept),
      numbers: value === undefined ? undefined : seriesOf(format)?.read(value as never),
      text: kept.line ?? formatValue(format, value as never, this.reach),
    };
  }

  /** Series of the values over time; `undefined` when they are not numeric. */
  get series(): ValueSeries | undefined {
    return this.#series;
  }

  /** Paths of the numbers that are kept. */
  get fields(): readonly string[] {
    return [...this.#fields.keys()];
  }

  /** Points by this computer's clock. */
  get points(): SeriesRing | undefined {
    return this.#ring;
  }

  /** Events, for data formats of which every record counts; `undefined` for others. */
  get events(): EventLog | undefined {
    return this.#events;
  }

  /** Returns the series at a path, and keeps it from then on. */
  lineOf(path: string): LinePoints | undefined {
    this.#wanted.add(path);
    if (!this.#ring) return undefined;
    this.#addField(path);
    const field = this.#fields.get(path);
    return field && this.#ring.line(field.line);
  }

  /** Returns an empty history for so many records that came before the topic was opened. */
  before(count: number): TopicHistory {
    const earlier = new TopicHistory(this.#limits, count);
    for (const path of this.#wanted) earlier.#wanted.add(path);
    return earlier;
  }

  /**
   * Puts the records of `earlier` before its own with higher numbers, unless its values are too large to keep: then there is nothing to plot.
   * The clock of `earlier` goes on: it knows when its records came, while the first own one may be older than it looks.
   */
  beginWith(earlier: TopicHistory): void {
    const kept = this.#log.kept();
    if (kept.some(({ value }) => value === undefined)) return;
    const last = earlier.count;
    for (const { number, format, value, timestampMs, clientId, arrivalMs } of kept) {
      if (number <= last) continue;
      earlier.add({ format, value, timestampMs, clientId } as TopicRecord, arrivalMs);
    }
    this.#latest ??= earlier.#latest;
    this.#latestLocalMs = earlier.#latestLocalMs;
    this.#clock = earlier.#clock;
    for (const path of this.#wanted) earlier.lineOf(path);
    this.#log = earlier.#log;
    this.#format = earlier.#format;
    this.#series = earlier.#series;
    this.#ring = earlier.#ring;
    this.#fields = earlier.#fields;
    this.#events = earlier.#events;
    this.#reach = earlier.#reach;
  }

  /** @param arrivalMs epoch milliseconds, this computer's clock */
  add(record: TopicRecord, arrivalMs: number): void {
    this.#take(record, arrivalMs, this.#clock.toLocalMs(record.timestampMs, arrivalMs));
  }

  #take(record: TopicRecord, arrivalMs: number, localMs: number): void {
    if (record.format !== this.#format) this.#begin(record);
    else if (this.count % LOOK_EVERY === 0) this.#lookForFields(record);
    this.#latest = record;
    this.#latestLocalMs = localMs;
    this.#reach.add(sparkNumbers(record.format, record.value), this.#latestLocalMs);
    this.#events?.add(record, this.#latestLocalMs);
    const sinceMs = this.#latestLocalMs - this.#limits.maxAgeMs;
    this.#log.add(record, arrivalMs, this.#latestLocalMs, {
      maxBytes: this.#limits.maxBytes / 2,
      sinceMs,
    });
    const ring = this.#ring;
    if (!ring || ring.lines === 0) return;
    const value = readable(record.format, record.value);
    ring.push(
      this.#latestLocalMs,
      Array.from(this.#fields.values(), ({ parts }) => readNumber(value, parts)),
    );
    ring.dropBefore(sinceMs);
  }

  /** Starts new series when the data format changes; the list of records continues. */
  #begin(record: TopicRecord): void {
    this.#format = record.format;
    this.#series = seriesOf(record.format);
    this.#events = EVENT_FORMATS.has(record.format) ? new EventLog() : undefined;
    this.#fields = new Map();
    const found = new Set([...(this.#series?.paths ?? []), ...this.#wanted]);
    for (const path of numberFields(record.format, record.value)) found.add(path);
    this.#ring = new SeriesRing(0, this.#maxPoints(found.size));
    for (const path of found) this.#addField(path);
  }

  #lookForFields({ format, value }: TopicRecord): void {
    if (this.#fields.size >= MAX_FIELDS) return;
    for (const path of numberFields(format, value)) this.#addField(path);
  }

  #addField(path: string): void {
    if (!this.#ring || this.#fields.has(path) || this.#fields.size >= MAX_COLUMNS) return;
    this.#fields.set(path, { line: this.#ring.addLine(), parts: partsOf(path) });
    this.#ring.setMaxPoints(this.#maxPoints(this.#ring.lines));
  }

  /** Number of points that fit into the half of the memory for numbers. */
  #maxPoints(lines: number): number {
    return this.#limits.maxBytes / 2 / (NUMBER_BYTES * (lines + 1));
  }
}

function deltaOf(
  before: KeptRecord | undefined,
  { timestampMs, arrivalMs }: KeptRecord,
): number | undefined {
  if (before === undefined) return undefined;
  if (timestampMs === undefined || before.timestampMs === undefined) {
    return arrivalMs - before.arrivalMs;
  }
  return timestampMs - before.timestampMs;
}
