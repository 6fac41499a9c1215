import type { StoredMessage } from '../mcap/chunk-content.ts';
import { timesOf } from '../mcap/file-index.ts';
import { readMetadata, type StoredPart } from '../mcap/stored-part.ts';
import { openFile } from '../mcap/open-file.ts';
import type { ForeignParts, RecordingSummary } from '../records/recording-summary.ts';
import type { RecordedRecord } from '../records/recorded-record.ts';
import {
  EVENT_TOPICS,
  type EventKind,
  type EventValue,
  type RecordedSession,
  type RecordingEvent,
} from '../records/recording-event.ts';
import { headerFromMetadata, PROFILE } from '../records/recording-header.ts';
import { READING_LIMITS } from '../storage/reading-limits.ts';
import type { RecordingSource } from '../storage/recording-storage.ts';
import { ChannelChunks, activityOf } from './channel-chunks.ts';
import { findLatest } from './find-latest.ts';
import { messagesInOrder } from './messages-in-order.ts';
import {
  markersOf,
  readEvents,
  withMarkers,
  type EventsOfFile,
  type MalformedEvents,
} from './recorded-events.ts';
import { StoredFile } from './stored-file.ts';
import { channelsOf, type FileChannels } from './topics-of.ts';

/** Events that each opening reads. */
const OPENING_KINDS: readonly EventKind[] = ['marker', 'client', 'gap'];

/** Which records, and in which order. */
export interface RecordsQuery {
  /** @default all */
  readonly topics?: readonly string[] | undefined;
  /** First time, inclusive. @default the start */
  readonly fromNs?: bigint | undefined;
  /** Last time, inclusive. @default the end */
  readonly untilNs?: bigint | undefined;
  /** From the last to the first. @default false */
  readonly isReverse?: boolean | undefined;
  /** Their chunks are not kept for later reads: for reading a whole recording beside others. @default false */
  readonly isOnce?: boolean | undefined;
}

/** What playback reads. */
export interface RecordsReader {
  readonly summary: RecordingSummary;
  /** Reads records by log time. Their bytes are shared with the reader: do not change them. */
  records(query?: RecordsQuery): AsyncIterable<RecordedRecord>;
  /** Finds the last record of each topic at a moment, the moment included. @param topics all by default */
  latestAt(timeNs: bigint, topics?: readonly string[]): Promise<Map<string, RecordedRecord>>;
}

/** What copies and exports read: records, and all that is beside them. */
export interface EventsReader extends RecordsReader {
  /** Returns all events, in the order in which they were written. */
  events(): Promise<RecordingEvent[]>;
  /** Returns all measurements of clocks, in the order in which they were made. */
  clocks(): Promise<RecordingEvent<'clock'>[]>;
  /** Finds the last record of each topic and publisher at a moment, the moment included. @param topics all by default */
  latestOfEachAt(timeNs: bigint, topics?: readonly string[]): Promise<RecordedRecord[]>;
  /** Returns what other programs put beside the messages. @param span time of the attachments; all by default */
  foreignParts(span?: Pick<RecordsQuery, 'fromNs' | 'untilNs'>): readonly StoredPart[];
}

/** How many records came when, in parts of equal length. */
export interface RecordingActivity {
  /** Records of all topics, or bytes in files whose chunks have no message indexes. */
  readonly all: Float32Array;
  /** Records of each topic, of all its publishers. */
  readonly topics: ReadonlyMap<string, Float32Array>;
}

/** Reads a recording by its indexes; files of other programs as well. Files without their end are opened up to the last whole chunk. */
export class RecordingReader implements EventsReader {
  readonly summary: RecordingSummary;
  /** Markers, clients and gaps that are not in the summary, because they are malformed. [RC-55] */
  readonly malformed: MalformedEvents | undefined;
  readonly #file: StoredFile;
  readonly #channels: FileChannels;
  readonly #chunks: ChannelChunks;

  private constructor(
    file: StoredFile,
    chunks: ChannelChunks,
    summary: RecordingSummary,
    malformed: MalformedEvents | undefined,
  ) {
    this.#file = file;
    this.#chunks = chunks;
    this.#channels = channelsOf(file.index);
    this.summary = summary;
    this.malformed = malformed;
  }

  /** @throws RecordingError when the source is no MCAP file */
  static async open(source: RecordingSource): Promise<RecordingReader> {
    const { index, source: whole, isDamaged } = await openFile(source);
    const file = new StoredFile(whole, index);
    const chunks = new ChannelChunks(index.chunks);
    const { records, topics } = channelsOf(index);
    const times = timesOf(chunks.ofAny(new Set(records.keys())));
    const isForeign = index.profile !== PROFILE;
    const header = headerFromMetadata(await readMetadata(whole, index, PROFILE));
    const opening = await eventsOf(file, chunks, OPENING_KINDS, READING_LIMITS.openingEvents);
    const { events, malformed } = opening;
    const markers = markersOf(events);
    const summary = {
      ...header,
      ...withMarkers(times, markers),
      records: topics.reduce((sum, topic) => sum + topic.records, 0),
      topics,
      markers,
      clients: lastOfEach(valuesOf(events, 'client')),
      gaps: valuesOf(events, 'gap'),
      foreignParts: describeParts(file.foreignParts()),
      isForeign,
      isDamaged,
    };
    return new RecordingReader(file, chunks, summary, malformed);
  }

  async *records(query: RecordsQuery = {}): AsyncGenerator<RecordedRecord> {
    const { startNs, endNs } = this.summary;
    const span = { fromNs: query.fromNs ?? startNs, untilNs: query.untilNs ?? endNs };
    const ids = this.#idsOf(query.topics);
    const chunks = this.#chunks.ofAny(ids);
    const messages = messagesInOrder(this.#file, chunks, ids, span, {
      isReverse: query.isReverse === true,
      isOnce: query.isOnce === true,
    });
    for await (const message of messages) yield this.#toRecord(message);
  }

  async latestAt(timeNs: bigint, topics?: readonly string[]): Promise<Map<string, RecordedRecord>> {
    const latest = new Map<string, RecordedRecord>();
    for (const record of await this.latestOfEachAt(timeNs, topics)) {
      const other = latest.get(record.topic);
      // Several clients may publish on a topic.
      if (other === undefined || other.logTimeNs <= record.logTimeNs) {
        latest.set(record.topic, record);
      }
    }
    return latest;
  }

  async latestOfEachAt(timeNs: bigint, topics?: readonly string[]): Promise<RecordedRecord[]> {
    const found = await findLatest(this.#file, this.#chunks, this.#idsOf(topics), timeNs);
    return Array.from(found.values(), (message) => this.#toRecord(message));
  }

  /** Counts the records over time from the index alone. @param parts of equal length into which the recording is divided */
  activity(parts: number): RecordingActivity {
    const { records } = this.#channels;
    const chunks = this.#chunks.ofAny(new Set(records.keys()));
    const { all, byChannel } = activityOf(chunks, records.keys(), this.summary, parts);
    const topics = new Map<string, Float32Array>();
    for (const [id, activity] of byChannel) {
      const { topic } = records.get(id)!;
      const sum = topics.get(topic);
      if (sum === undefined) topics.set(topic, activity);
      else for (const [part, count] of activity.entries()) sum[part]! += count;
    }
    return { all, topics };
  }

  foreignParts({ fromNs, untilNs }: Pick<RecordsQuery, 'fromNs' | 'untilNs'> = {}): StoredPart[] {
    return this.#file.foreignParts().filter((part) => {
      if (part.kind === 'metadata') return true;
      const { logTime } = part.entry;
      return (fromNs ?? logTime) <= logTime && logTime <= (untilNs ?? logTime);
    });
  }

  events(): Promise<RecordingEvent[]> {
    return this.#events(Object.keys(EVENT_TOPICS) as EventKind[]);
  }

  /** Returns the sessions as they were at a moment, by id. */
  async sessionsAt(timeNs: bigint): Promise<Map<string, RecordedSession>> {
    const before = (await this.sessions()).filter((event) => event.timeNs <= timeNs);
    return new Map(before.map(({ value }) => [value.id, value]));
  }

  /** Returns all changes of sessions, in the order in which they happened. */
  async sessions(): Promise<RecordingEvent<'session'>[]> {
    const events = await this.#events(['session']);
    return events.filter((event) => event.kind === 'session');
  }

  async clocks(): Promise<RecordingEvent<'clock'>[]> {
    const events = await this.#events(['clock']);
    return events.filter((event) => event.kind === 'clock');
  }

  /** Returns all registrations of devices and their ends, in the order in which they happened. */
  async devices(): Promise<RecordingEvent<'device'>[]> {
    const events = await this.#events(['device']);
    return events.filter((event) => event.kind === 'device');
  }

  async #events(kinds: readonly EventKind[]): Promise<RecordingEvent[]> {
    const { events } = await eventsOf(this.#file, this.#chunks, kinds);
    return [...events];
  }

  #idsOf(topics: readonly string[] | undefined): Set<number> {
    const { records } = this.#channels;
    if (topics === undefined) return new Set(records.keys());
    const wanted = new Set(topics);
    const channels = [...records.values()].filter(({ topic }) => wanted.has(topic));
    return new Set(channels.map(({ id }) => id));
  }

  #toRecord({ channelId, data, logTimeNs, publishTimeNs }: StoredMessage): RecordedRecord {
    const { topic, metadata } = this.#channels.records.get(channelId)!;
    const clientId = metadata.get('clientId') ?? '';
    const foreign = this.#channels.foreign.get(channelId);
    return {
      topic,
      clientId,
      record: data,
      logTimeNs,
      publishTimeNs,
      ...(foreign && { foreign }),
    };
  }
}

function describeParts(parts: readonly StoredPart[]): ForeignParts {
  return {
    attachments: parts.flatMap(({ kind, entry }) => {
      if (kind === 'metadata') return [];
      const { name, mediaType, dataSize, logTime } = entry;
      return [{ name, mediaType, sizeBytes: Number(dataSize), logTimeNs: logTime }];
    }),
    metadata: parts.flatMap(({ kind, entry }) => (kind === 'metadata' ? entry.name : [])),
  };
}

function eventsOf(
  file: StoredFile,
  chunks: ChannelChunks,
  kinds: readonly EventKind[],
  maxEvents?: number,
): Promise<EventsOfFile> {
  const wanted = [...channelsOf(file.index).events].filter(([, kind]) => kinds.includes(kind));
  return readEvents(file, chunks, new Map(wanted), maxEvents);
}

function valuesOf<K extends EventKind>(events: readonly RecordingEvent[], kind: K) {
  return events.filter((event) => event.kind === kind).map(({ value }) => value as EventValue<K>);
}

function lastOfEach<T extends { readonly id: string }>(values: readonly T[]): T[] {
  return [...new Map(values.map((value) => [value.id, value])).values()];
}
