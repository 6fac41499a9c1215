import {
  RecordingWriter,
  type RecordedRecord,
  type RecordingEvent,
  type RecordingHeader,
} from '@ubii/recording';
import { MemoryFile, SAMPLE_HEADER, SAMPLE_START_NS, sampleRecord } from '@ubii/recording/testing';

/** A whole file with a header and events of any content. */
export async function recordingWith(
  header: Partial<RecordingHeader>,
  events: readonly RecordingEvent[] = [],
  records: readonly RecordedRecord[] = [sampleRecord('/a', 0), sampleRecord('/a', 10)],
): Promise<Uint8Array> {
  const file = new MemoryFile();
  const writer = await RecordingWriter.create(file, { ...SAMPLE_HEADER, ...header });
  for (const event of events) writer.addEvent(event);
  for (const record of records) await writer.addRecord(record);
  await writer.end();
  return file.bytes;
}

/** An event that is written as any JSON. */
export function malformedEvent(kind: RecordingEvent['kind'], json: unknown): RecordingEvent {
  // The writer reads ids of some events before it writes them.
  const value = { id: JSON.stringify(json), name: '', toJSON: () => json };
  return { kind, timeNs: SAMPLE_START_NS, value } as unknown as RecordingEvent;
}

/** A marker as it should be. */
export const MARKER = { id: 'm', timeMs: 0, text: '', author: '', authorId: '', kind: 'key' };

/** Events that readers of a file may stumble over. */
export const MALFORMED_EVENTS: Readonly<Record<string, readonly RecordingEvent[]>> = {
  'a marker whose text is an object': [malformedEvent('marker', { ...MARKER, text: { a: 1 } })],
  'a marker that is null': [malformedEvent('marker', null)],
  'a marker whose time is a text': [malformedEvent('marker', { ...MARKER, timeMs: 'noon' })],
  'a marker at no time': [malformedEvent('marker', { ...MARKER, timeMs: 1e308 })],
  'a client that is a number': [malformedEvent('client', 7)],
  'a gap of a text': [malformedEvent('gap', { fromMs: 'a', untilMs: null, records: 'many' })],
  'a device without components': [malformedEvent('device', { id: 'd', components: null })],
  'a session that cannot be parsed': [malformedEvent('session', { id: 's', session: '{' })],
  'a clock that is a list': [malformedEvent('clock', [1])],
};
