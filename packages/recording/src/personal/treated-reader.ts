import { DATA_FORMATS } from '@ubii/proto';

import { cutRecording, type CutOptions } from '../cut/cut-recording.ts';
import type { EventsReader, RecordsQuery } from '../reading/recording-reader.ts';
import type { RecordedRecord } from '../records/recorded-record.ts';
import type { EventKind, EventValue, RecordingEvent } from '../records/recording-event.ts';
import type { RecordedTopic, RecordingSummary } from '../records/recording-summary.ts';
import type { RecordingSink } from '../storage/recording-storage.ts';
import type { WriterStatistics } from '../writing/recording-writer.ts';
import type { Treatment } from './create-treatment.ts';

/** A recording as it is shared: everything that is read passes the treatment. Exports read it like any other. */
export class TreatedReader implements EventsReader {
  readonly summary: RecordingSummary;
  readonly #reader: EventsReader;
  readonly #treatment: Treatment;
  /** Topics of the file, by how they are shared. */
  readonly #originals = new Map<string, Set<string>>();

  constructor(reader: EventsReader, treatment: Treatment) {
    this.#reader = reader;
    this.#treatment = treatment;
    this.summary = treatedSummary(reader.summary, treatment);
    for (const { topic } of reader.summary.topics) {
      const shared = treatment.topic(topic);
      if (shared === undefined) continue;
      this.#originals.set(shared, (this.#originals.get(shared) ?? new Set()).add(topic));
    }
  }

  async *records(query: RecordsQuery = {}): AsyncGenerator<RecordedRecord> {
    const { shiftNs } = this.#treatment;
    const { fromNs, untilNs } = query;
    const original = {
      ...query,
      topics: this.#originalsOf(query.topics),
      fromNs: fromNs === undefined ? undefined : fromNs - shiftNs,
      untilNs: untilNs === undefined ? undefined : untilNs - shiftNs,
    };
    for await (const record of this.#reader.records(original)) {
      const shared = this.#treatment.record(record);
      if (shared !== undefined) yield shared;
    }
  }

  async latestAt(timeNs: bigint, topics?: readonly string[]): Promise<Map<string, RecordedRecord>> {
    const latest = await this.#reader.latestAt(...this.#originalMoment(timeNs, topics));
    return new Map(this.#treated(latest.values()).map((record) => [record.topic, record]));
  }

  async latestOfEachAt(timeNs: bigint, topics?: readonly string[]): Promise<RecordedRecord[]> {
    return this.#treated(
      await this.#reader.latestOfEachAt(...this.#originalMoment(timeNs, topics)),
    );
  }

  async events(): Promise<RecordingEvent[]> {
    const events = await this.#reader.events();
    return events.flatMap((event) => this.#treatment.event(event) ?? []);
  }

  /** They cannot be searched. [PD-14] */
  foreignParts(): readonly [] {
    return [];
  }

  async clocks(): Promise<RecordingEvent<'clock'>[]> {
    const events = await this.events();
    return events.filter((event) => event.kind === 'clock');
  }

  #treated(records: Iterable<RecordedRecord>): RecordedRecord[] {
    return [...records].flatMap((record) => this.#treatment.record(record) ?? []);
  }

  #originalMoment(timeNs: bigint, topics: readonly string[] | undefined): [bigint, string[]] {
    return [timeNs - this.#treatment.shiftNs, this.#originalsOf(topics)];
  }

  /** Without a choice, all that are shared at all. */
  #originalsOf(topics: readonly string[] | undefined): string[] {
    const chosen = topics ?? [...this.#originals.keys()];
    return chosen.flatMap((topic) => [...(this.#originals.get(topic) ?? [])]);
  }
}

function treatedSummary(summary: RecordingSummary, treatment: Treatment): RecordingSummary {
  const { startNs, endNs } = summary;
  const shift = summary.records === 0 ? 0n : treatment.shiftNs;
  const values = <K extends EventKind>(kind: K, list: readonly EventValue<K>[]) =>
    list.flatMap((value) => {
      const event = { kind, timeNs: endNs, value } as unknown as RecordingEvent;
      return (treatment.event(event)?.value as EventValue<K> | undefined) ?? [];
    });
  const topics = treatedTopics(summary.topics, treatment);
  const { isForeign, isDamaged } = summary;
  return {
    ...treatment.header(summary),
    startNs: startNs + shift,
    endNs: endNs + shift,
    records: topics.reduce((sum, { records }) => sum + records, 0),
    topics,
    markers: values('marker', summary.markers),
    clients: values('client', summary.clients),
    gaps: values('gap', summary.gaps),
    foreignParts: { attachments: [], metadata: [] },
    isForeign,
    isDamaged,
  };
}

/** Topics that are shared under one name are one. */
function treatedTopics(
  topics: readonly RecordedTopic[],
  treatment: Treatment,
): readonly RecordedTopic[] {
  const shared = new Map<string, RecordedTopic>();
  for (const row of topics) {
    const topic = treatment.topic(row.topic);
    if (topic === undefined) continue;
    const clientId = treatment.clientId(row.clientId);
    const key = `${clientId} ${topic}`;
    const records = row.records + (shared.get(key)?.records ?? 0);
    const clientName = treatment.clientName(row.clientName);
    const format = Object.hasOwn(DATA_FORMATS, row.format) ? row.format : '';
    shared.set(key, { ...row, topic, clientId, clientName, format, records });
  }
  return [...shared.values()];
}

/**
 * Writes a recording, or a part of it, as it is shared. Nothing is copied that did not pass the treatment: other metadata and
 * attachments stay behind, snapshots of last values are made of treated records.
 *
 * @param options topics and span as they are shared, see `TreatedReader`
 * @throws RecordingError when nothing is left; the reason of the signal; the error of the sink
 */
export function treatRecording(
  reader: EventsReader,
  sink: RecordingSink,
  treatment: Treatment,
  options: CutOptions = {},
): Promise<WriterStatistics> {
  return cutRecording(new TreatedReader(reader, treatment), sink, options);
}
