import type { EventsReader } from '../reading/recording-reader.ts';
import type { RecordedRecord } from '../records/recorded-record.ts';
import { RecordingError } from '../records/recording-error.ts';
import { stateKey, type Gap, type RecordingEvent } from '../records/recording-event.ts';
import type { RecordingHeader } from '../records/recording-header.ts';
import type { RecordingSink } from '../storage/recording-storage.ts';
import { RecordingWriter, type WriterStatistics } from '../writing/recording-writer.ts';

/** Nanoseconds since the Unix epoch, both inclusive. */
interface SpanNs {
  readonly fromNs: bigint;
  readonly untilNs: bigint;
}

/**
 * The events that apply in a span, by time: states from before at its beginning, markers as they are now, gaps that reach
 * into it.
 *
 * @param events in the order in which they were written
 */
function eventsOfSpan(
  events: readonly RecordingEvent[],
  { fromNs, untilNs }: SpanNs,
): RecordingEvent[] {
  const before = new Map<string, RecordingEvent>();
  const markers = new Map<string, RecordingEvent>();
  const within: RecordingEvent[] = [];
  for (const event of events) {
    const key = stateKey(event);
    if (event.kind === 'marker') markers.set(event.value.id, event);
    else if (event.kind === 'gap') {
      if (reaches(event.value, { fromNs, untilNs })) within.push(event);
    } else if (key !== undefined && event.timeNs < fromNs) before.set(key, event);
    else if (event.timeNs <= untilNs) within.push(event);
  }
  for (const event of markers.values()) {
    const isWithin = event.timeNs >= fromNs && event.timeNs <= untilNs;
    const isRemoved = event.kind === 'marker' && event.value.isRemoved === true;
    if (isWithin && !isRemoved) within.push(event);
  }
  within.sort((a, b) => (a.timeNs === b.timeNs ? 0 : a.timeNs < b.timeNs ? -1 : 1));
  return [...Array.from(before.values(), (event) => ({ ...event, timeNs: fromNs })), ...within];
}

function reaches({ fromMs, untilMs }: Gap, { fromNs, untilNs }: SpanNs): boolean {
  return fromMs * 1e6 <= Number(untilNs) && untilMs * 1e6 >= Number(fromNs);
}

/** What of a recording a cut reads. */
export type CutSource = Pick<
  EventsReader,
  'summary' | 'records' | 'latestOfEachAt' | 'events' | 'foreignParts'
>;

/** What is cut out, and callbacks. */
export interface CutOptions extends Partial<SpanNs> {
  /** @default all */
  readonly topics?: readonly string[] | undefined;
  /** Members that replace those of the recording. */
  readonly header?: Partial<RecordingHeader>;
  readonly signal?: { throwIfAborted(): void } | undefined;
  /** Told now and then: records read so far. */
  readonly onProgress?: ((records: number) => void) | undefined;
}

/** Records between two messages of progress. */
const PROGRESS_RECORDS = 1000;

/**
 * Writes a span and some topics of a recording as a recording of its own. Records are copied bit for bit. The last value
 * of each topic and publisher before the span stands at its beginning, with the time at which it was published, as do the
 * states of sessions, clients, devices and clocks. Messages of other programs are copied with their schemas, as are their metadata
 * and their attachments of the span; a source that must not tell them, as that of a shared recording, has none.
 *
 * @throws RecordingError when nothing is left; the reason of the signal; the error of the sink
 */
export async function cutRecording(
  source: CutSource,
  sink: RecordingSink,
  options: CutOptions = {},
): Promise<WriterStatistics> {
  const { summary } = source;
  const { signal, onProgress } = options;
  const span = {
    fromNs: options.fromNs ?? summary.startNs,
    untilNs: options.untilNs ?? summary.endNs,
  };
  const topics = chosenTopics(source, options.topics);
  const { name, kind, masterName, version, notes, selection, personalData } = summary;
  const writer = await RecordingWriter.create(sink, {
    name,
    kind,
    masterName,
    version,
    notes,
    selection,
    ...(personalData !== undefined && { personalData }),
    ...options.header,
  });
  const addEvents = eventFeed(eventsOfSpan(await source.events(), span), writer);
  addEvents(span.fromNs);
  for (const record of await standingBefore(source, topics, span.fromNs))
    await writer.addRecord(record);
  let count = 0;
  for await (const record of source.records({ ...span, topics })) {
    signal?.throwIfAborted();
    if (++count % PROGRESS_RECORDS === 0) onProgress?.(count);
    addEvents(record.logTimeNs);
    await writer.addRecord(record);
  }
  addEvents(span.untilNs);
  signal?.throwIfAborted();
  if (writer.statistics.records === 0) {
    throw new RecordingError('There are no records of these topics in this span.');
  }
  for (const part of source.foreignParts(options)) {
    signal?.throwIfAborted();
    await writer.addPart(part);
  }
  await writer.end();
  return writer.statistics;
}

function chosenTopics({ summary }: CutSource, topics: readonly string[] | undefined): string[] {
  const all = new Set(summary.topics.map(({ topic }) => topic));
  return [...all].filter((topic) => topics?.includes(topic) !== false);
}

async function standingBefore(
  source: CutSource,
  topics: readonly string[],
  fromNs: bigint,
): Promise<RecordedRecord[]> {
  if (fromNs <= source.summary.startNs) return [];
  const standing = await source.latestOfEachAt(fromNs - 1n, topics);
  return standing.map((record) => ({ ...record, logTimeNs: fromNs }));
}

/** Adds events before the records that came after them, so that topics have the names that clients had then. */
function eventFeed(
  events: readonly RecordingEvent[],
  writer: RecordingWriter,
): (untilNs: bigint) => void {
  let next = 0;
  return (untilNs) => {
    for (let event = events[next]; event && event.timeNs <= untilNs; event = events[++next]) {
      writer.addEvent(event);
    }
  };
}
