import { isDataFormat, type DataFormat } from '@ubii/proto';
import { RecordingError } from '../../records/recording-error.ts';
import type { RecordingSink, RecordingSource } from '../../storage/recording-storage.ts';
import { levelOf } from '../csv/csv-plan.ts';
import { ImportWriter, type ImportOptions, type ImportResult } from '../import-writer.ts';
import { hasPaths, valueFromPaths } from '../value-from-paths.ts';
import { ClockFit, type ClockOffset } from './clock-fit.ts';
import {
  element,
  parseStream,
  SampleReader,
  XDF_TAG,
  XdfSource,
  type XdfStream,
} from './xdf-stream.ts';

/** Which streams are imported. */
export interface XdfImportOptions {
  /** Topics of streams. @default all */
  readonly topics?: readonly string[] | undefined;
}

/** A stream, and what becomes of it. */
export interface XdfTopic {
  readonly stream: XdfStream;
  readonly topic: string;
  /** Undefined for a stream whose texts become markers. */
  readonly format: DataFormat | undefined;
  readonly clientId: string;
}

/** What is in a file. */
export interface XdfPlan {
  readonly topics: readonly XdfTopic[];
  /** Where the file cannot be read any more, as a sentence. */
  readonly damage: string | undefined;
}

/** Says what is in an XDF file. @throws RecordingError when it is none */
export async function previewXdf(source: RecordingSource): Promise<XdfPlan> {
  const file = await XdfSource.open(source);
  const { streams } = await surveyOf(file);
  return { topics: topicsOf([...streams.values()]), damage: file.damage };
}

/**
 * Imports an XDF file as a recording: a topic for each stream, markers for streams of type `Markers`. Times are those of
 * the recorder: clock offsets are applied as `pyxdf` does with `dejitter_timestamps=False`. A damaged file is read up to
 * the damage.
 *
 * @throws RecordingError when it has nothing to keep; the reason of the signal; the error of the sink
 */
export async function importXdf(
  source: RecordingSource,
  sink: RecordingSink,
  options: ImportOptions & XdfImportOptions,
): Promise<ImportResult> {
  const file = await XdfSource.open(source);
  const survey = await surveyOf(file);
  const writer = await ImportWriter.create(sink, options, notesOf([...survey.streams.values()]));
  const topics = topicsOf([...survey.streams.values()]).filter(
    ({ topic }) => options.topics?.includes(topic) !== false,
  );
  const shiftNs = shiftOf(survey, options.startMs ?? 0);
  const feeds = new Map(
    topics.map((topic) => {
      const fit = new ClockFit(survey.offsets.get(topic.stream.id) ?? []);
      return [topic.stream.id, { ...topic, fit, reader: new SampleReader(topic.stream) }];
    }),
  );
  for await (const chunk of file.chunks()) {
    if (chunk.tag !== XDF_TAG.samples || chunk.length < 4) continue;
    const content = await file.content(chunk);
    const feed = feeds.get(uint32(content));
    if (feed === undefined) continue;
    try {
      for (const { time, values } of feed.reader.read(content.subarray(4))) {
        const timeNs = nanoseconds(feed.fit.correct(time)) + shiftNs;
        await addSample(writer, feed, values, timeNs, chunk.offset / file.size);
      }
    } catch (error) {
      if (!(error instanceof RangeError)) throw error;
      file.damageAt(chunk.offset);
      break;
    }
  }
  return writer.end(file.damage === undefined ? [] : [file.damage]);
}

interface Survey {
  readonly streams: ReadonlyMap<number, XdfStream>;
  readonly offsets: ReadonlyMap<number, readonly ClockOffset[]>;
  /** The earliest first time of a stream, corrected, seconds. */
  readonly firstTime: number;
  /** When the file was begun, milliseconds since the Unix epoch. */
  readonly beganMs: number | undefined;
}

/** Reads everything but the samples. */
async function surveyOf(file: XdfSource): Promise<Survey> {
  const streams = new Map<number, XdfStream>();
  const offsets = new Map<number, ClockOffset[]>();
  const firstTimes = new Map<number, number>();
  let beganMs: number | undefined;
  const text = new TextDecoder();
  for await (const chunk of file.chunks()) {
    if (chunk.tag === XDF_TAG.fileHeader) {
      const began = Date.parse(element(text.decode(await file.content(chunk)), 'datetime'));
      if (!Number.isNaN(began)) beganMs = began;
    } else if (chunk.length < 4) continue;
    else if (chunk.tag === XDF_TAG.streamHeader) {
      const content = await file.content(chunk);
      const stream = parseStream(uint32(content), text.decode(content.subarray(4)));
      streams.set(stream.id, stream);
    } else if (chunk.tag === XDF_TAG.clockOffset && chunk.length >= 20) {
      const content = await file.content(chunk);
      const id = uint32(content);
      const list = offsets.get(id) ?? [];
      list.push({ time: float64(content, 4), offset: float64(content, 12) });
      offsets.set(id, list);
    } else if (chunk.tag === XDF_TAG.samples) {
      const head = await file.content({ ...chunk, length: Math.min(chunk.length, 32) });
      const at = 4 + 1 + (head[4] ?? 0);
      const hasTime = head[at] === 8 && head.length >= at + 9;
      if (hasTime && !firstTimes.has(uint32(head)))
        firstTimes.set(uint32(head), float64(head, at + 1));
    }
  }
  if (streams.size === 0) throw new RecordingError('The file has no streams.');
  const corrected = [...firstTimes].map(([id, time]) =>
    new ClockFit(offsets.get(id) ?? []).correct(time),
  );
  return { streams, offsets, beganMs, firstTime: Math.min(...corrected) };
}

/** Clocks of the Lab Streaming Layer often count from the start of a computer: then the file says when that was, or the caller. */
function shiftOf({ firstTime, beganMs }: Survey, startMs: number): bigint {
  const YEAR_1973 = 100_000_000;
  if (!Number.isFinite(firstTime) || firstTime > YEAR_1973) return 0n;
  return nanoseconds((beganMs ?? startMs) / 1000) - nanoseconds(firstTime);
}

function topicsOf(streams: readonly XdfStream[]): XdfTopic[] {
  const taken = new Set<string>();
  return streams.map((stream) => {
    const { name, sourceId } = stream;
    // Our own exports name a stream after its topic, and its source after publisher and topic.
    const isExport = name.startsWith('/') && sourceId.endsWith(name);
    const clientId = isExport ? sourceId.slice(0, -name.length) : sourceId;
    let topic = isExport ? name : `/${levelOf(name) || `stream-${stream.id}`}`;
    if (taken.has(`${clientId} ${topic}`)) topic = `${topic}-${stream.id}`;
    taken.add(`${clientId} ${topic}`);
    return { stream, topic, clientId, format: formatOf(stream, isExport) };
  });
}

function formatOf(
  { type, format, channels, labels }: XdfStream,
  isExport: boolean,
): DataFormat | undefined {
  if (isExport && isDataFormat(type) && labels.length > 0 && !type.startsWith('image')) return type;
  const isText = format === 'string';
  if (isText && channels === 1 && /marker|event|annotation/i.test(type)) return undefined;
  if (channels === 1) return isText ? 'string' : 'double';
  return isText ? 'stringList' : 'doubleList';
}

/** Names of channels that become elements of a list. */
function notesOf(streams: readonly XdfStream[]): string {
  return topicsOf(streams)
    .filter(({ format, stream }) => format?.endsWith('List') === true && stream.labels.length > 0)
    .map(({ topic, stream }) => `${topic}: ${stream.labels.join(', ')}`)
    .join('\n');
}

async function addSample(
  writer: ImportWriter,
  { topic, format, clientId, stream }: XdfTopic,
  values: readonly (number | string)[],
  timeNs: bigint,
  share: number,
): Promise<void> {
  if (format === undefined)
    return writer.addMarker(String(values[0] ?? ''), stream.name, timeNs, share);
  writer.addClient(clientId, stream.host || stream.name, timeNs);
  const value = valueOf(format, stream, values);
  const times = { publishTimeNs: timeNs, logTimeNs: timeNs };
  await writer.addValue({ topic, clientId, format, value, ...times }, share);
}

function valueOf(
  format: DataFormat,
  { type, labels }: XdfStream,
  values: readonly (number | string)[],
): unknown {
  if (format === type && labels.length > 0) {
    // In exports, members that a record does not have are empty texts and NaN.
    const isWhole = hasPaths(format, labels);
    const leaves = labels.map((label, place) => [label, values[place]] as const);
    const isTold = (value: unknown): boolean => value !== '' && !Number.isNaN(value);
    return valueFromPaths(
      format,
      leaves.filter(([, value]) => isWhole || isTold(value)),
    );
  }
  return format.endsWith('List') ? { elements: values } : values[0];
}

function uint32(bytes: Uint8Array): number {
  return new DataView(bytes.buffer, bytes.byteOffset).getUint32(0, true);
}

function float64(bytes: Uint8Array, at: number): number {
  return new DataView(bytes.buffer, bytes.byteOffset).getFloat64(at, true);
}

/** Whole seconds and their part apart: a double of both has no nanoseconds. */
function nanoseconds(seconds: number): bigint {
  const whole = Math.floor(seconds);
  return BigInt(whole) * 1_000_000_000n + BigInt(Math.round((seconds - whole) * 1e9));
}
