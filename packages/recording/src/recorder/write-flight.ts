import { FLIGHT_TARGET, type SharedReader } from '../arena/shared-records.ts';
import type { NamedChannel } from '../arena/channels.ts';
import { gapEvent } from './facts.ts';
import { nsOf, recordedOf, type RecordedRecord } from '../records/recorded-record.ts';
import type { RecordingWriter } from '../writing/recording-writer.ts';
import type { FlightSnapshot } from './flight-recorder.ts';

const OVERWRITTEN = 'New records took the place of the oldest ones while these were being kept.';

/** Writes what the flight recorder held; values and states that are older and still stood are written at the beginning. */
export async function writeFlight(
  { spans, records, startMs, standing, events, ...snapshot }: FlightSnapshot,
  reader: SharedReader | undefined,
  writer: RecordingWriter,
): Promise<void> {
  const startNs = nsOf(startMs);
  const channels = new Map(snapshot.channels.map((channel) => [channel.number, channel]));
  const stood = new Map<number, RecordedRecord>();
  for (const { channel, timeMs, record } of standing) {
    const source = channels.get(channel);
    if (source !== undefined) stood.set(channel, recordedOf(source, record, timeMs));
  }
  for (const event of events) {
    const timeNs = event.timeNs < startNs ? startNs : event.timeNs;
    writer.addEvent({ ...event, timeNs });
  }
  let read = 0;
  let firstMs: number | undefined;
  let hasBegun = false;
  for (const entry of reader?.read(spans) ?? []) {
    firstMs ??= entry.timeMs;
    if (entry.record.length > 0) read++;
    const source = channels.get(entry.channel);
    if ((entry.targets & FLIGHT_TARGET) === 0 || source === undefined) continue;
    const recorded = recordedOf(source, entry.record, entry.timeMs);
    if (entry.record.length === 0) {
      if (recorded.logTimeNs <= startNs) forgetTopic(stood, source);
    } else if (recorded.logTimeNs < startNs) {
      // In place of the earlier one, behind all others.
      stood.delete(entry.channel);
      stood.set(entry.channel, recorded);
    } else {
      if (!hasBegun) await writeAt(startNs, stood.values(), writer);
      hasBegun = true;
      await writer.addRecord(recorded);
    }
  }
  if (!hasBegun) await writeAt(startNs, stood.values(), writer);
  if (read < records) {
    writer.addEvent(gapEvent(startMs, firstMs ?? startMs, records - read, OVERWRITTEN));
  }
}

function forgetTopic(stood: Map<number, RecordedRecord>, { topic }: NamedChannel): void {
  for (const [number, record] of stood) if (record.topic === topic) stood.delete(number);
}

async function writeAt(
  logTimeNs: bigint,
  records: Iterable<RecordedRecord>,
  writer: RecordingWriter,
): Promise<void> {
  for (const record of records) await writer.addRecord({ ...record, logTimeNs });
}
