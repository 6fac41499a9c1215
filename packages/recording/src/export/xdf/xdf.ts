import type { EventsReader } from '../../reading/recording-reader.ts';
import type { RecordedTopic } from '../../records/recording-summary.ts';
import { topicTable, type Cell, type TableOptions, type TopicTable } from '../topic-table.ts';
import {
  footerXml,
  headerXml,
  clockOffset,
  fileHeader,
  samples,
  streamFooter,
  streamHeader,
  type Sample,
} from './xdf-chunks.ts';

/** Options of an export as XDF. */
export interface XdfOptions extends Omit<TableOptions, 'clientId'> {
  /** @default all */
  readonly topics?: readonly string[];
}

/** Samples in one chunk. */
const SAMPLES_PER_CHUNK = 500;

/**
 * A recording as XDF 1.0, in parts. Each topic of each publisher is a stream, with a channel for each member of the value:
 * doubles, or texts when a member is a text. Samples have the time of the publisher's clock; the offsets of that clock are
 * in the stream, so that readers such as `pyxdf` bring all streams to the master's time. Markers are a stream of texts.
 *
 * @throws the reason of `options.signal` when it is aborted
 */
export async function* xdfOf(
  reader: EventsReader,
  options: XdfOptions = {},
): AsyncGenerator<Uint8Array> {
  yield fileHeader();
  const clocks = await reader.clocks();
  let stream = 0;
  for (const topic of reader.summary.topics) {
    if (topic.isRaw || options.topics?.includes(topic.topic) === false) continue;
    const table = await topicTable(reader, topic.topic, { ...options, clientId: topic.clientId });
    const offsets = clocks.flatMap(({ timeNs, value }) =>
      value.clientId === topic.clientId
        ? [{ time: seconds(timeNs), offset: -value.offsetMs / 1000 }]
        : [],
    );
    yield* topicStream(++stream, topic, table, offsets);
  }
  const markers = markersOf(reader, options);
  if (markers.length > 0) {
    const list = markers.map(({ timeMs, text }) => ({ time: timeMs / 1000, values: [text] }));
    yield streamHeader(
      ++stream,
      headerXml({
        name: 'Markers',
        type: 'Markers',
        channels: ['text'],
        format: 'string',
        sourceId: 'markers',
        host: reader.summary.masterName,
      }),
    );
    yield samples(stream, list);
    yield streamFooter(stream, footerXml(list[0]!.time, list.at(-1)!.time, list.length));
  }
}

function markersOf({ summary }: Pick<EventsReader, 'summary'>, { fromNs, untilNs }: XdfOptions) {
  const fromMs = fromNs === undefined ? -Infinity : Number(fromNs) / 1e6;
  const untilMs = untilNs === undefined ? Infinity : Number(untilNs) / 1e6;
  return summary.markers.filter(({ timeMs }) => timeMs >= fromMs && timeMs <= untilMs);
}

async function* topicStream(
  stream: number,
  { topic, clientId, clientName, format }: RecordedTopic,
  table: TopicTable,
  offsets: readonly { time: number; offset: number }[],
): AsyncGenerator<Uint8Array> {
  const { columns } = table;
  const isNumeric = columns.length > 0 && columns.every(({ type }) => type !== 'string');
  const valueOf: (cell: Cell) => number | string = isNumeric ? numberOf : textOf;
  yield streamHeader(
    stream,
    headerXml({
      name: topic,
      type: format,
      channels: columns.map(({ name }) => name),
      format: isNumeric ? 'double64' : 'string',
      sourceId: `${clientId}${topic}`,
      host: clientName,
    }),
  );
  let part: Sample[] = [];
  let [first, last, count] = [0, 0, 0];
  let hasOwnTimes = false;
  for await (const { publishTimeNs, logTimeNs, cells } of table.rows()) {
    hasOwnTimes ||= publishTimeNs !== logTimeNs;
    last = seconds(publishTimeNs);
    if (count++ === 0) first = last;
    part.push({ time: last, values: cells.map(valueOf) });
    if (part.length < SAMPLES_PER_CHUNK) continue;
    yield samples(stream, part);
    part = [];
  }
  if (part.length > 0) yield samples(stream, part);
  // Times that are the master's already need no offset.
  if (hasOwnTimes) {
    for (const { time, offset } of offsets) yield clockOffset(stream, time, offset);
  }
  yield streamFooter(stream, footerXml(first, last, count));
}

function numberOf(cell: Cell): number {
  return cell === undefined ? NaN : Number(cell);
}

function textOf(cell: Cell): string {
  return cell === undefined ? '' : String(cell);
}

function seconds(timeNs: bigint): number {
  return Number(timeNs) / 1e9;
}
