import type { FlightRecords } from './generated/messages.ts';

/** An encoded `ubii.topicData.TopicDataRecord` that the flight recorder holds. */
export interface FlightRecord {
  /** When it came, epoch milliseconds of the clock of the master. */
  readonly timeMs: number;
  readonly record: Uint8Array;
}

/** The records of a reply, oldest first; views on its memory. Ends early where lengths and bytes differ. [RC-36] */
export function* unpackFlightRecords({
  timesMs,
  lengths,
  records,
}: FlightRecords): Generator<FlightRecord> {
  let at = 0;
  for (const [index, length] of lengths.entries()) {
    const timeMs = timesMs[index];
    if (timeMs === undefined || length < 0 || at + length > records.length) return;
    yield { timeMs, record: records.subarray(at, at + length) };
    at += length;
  }
}
