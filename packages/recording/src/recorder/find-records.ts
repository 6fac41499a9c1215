import type { FlightRecords } from '@ubii/proto';
import { FLIGHT_TARGET, type RecordSpans } from '../arena/shared-records.ts';
import type { NamedChannel } from '../arena/channels.ts';
import type { RingEntry } from '../arena/shared-ring.ts';

/** Which records of the flight recorder to read. [RC-36] */
export interface RecordSearch {
  readonly topics: readonly string[];
  /** Those that came before this moment are left out, epoch milliseconds. */
  readonly sinceMs: number;
  /** Of the records of all topics; each gets an equal share. */
  readonly maxBytes: number;
}

/** Where the records of a search are. */
export interface FoundSpans extends RecordSearch {
  readonly spans: RecordSpans;
  /** Those of the topics. */
  readonly channels: readonly NamedChannel[];
}

/** A record that was found. */
interface Found {
  /** Number among all that were read. */
  readonly number: number;
  readonly timeMs: number;
  readonly record: Uint8Array<ArrayBuffer>;
}

/** Records of a topic; the oldest ones are left out when they are too many bytes. */
class Newest {
  readonly #maxBytes: number;
  #found: Found[] = [];
  #first = 0;
  #bytes = 0;

  constructor(maxBytes: number) {
    this.#maxBytes = maxBytes;
  }

  add(found: Found): void {
    this.#bytes += found.record.length;
    this.#found.push(found);
    while (this.#bytes > this.#maxBytes) this.#bytes -= this.#found[this.#first++]!.record.length;
    if (this.#first <= this.#found.length / 2) return;
    this.#found = this.#found.slice(this.#first);
    this.#first = 0;
  }

  list(): readonly Found[] {
    return this.#found.slice(this.#first);
  }
}

/** Finds the newest records of some topics. */
export function findRecords(
  entries: Iterable<RingEntry>,
  { topics, channels, sinceMs, maxBytes }: FoundSpans,
): FlightRecords {
  const byTopic = new Map(topics.map((topic) => [topic, new Newest(maxBytes / topics.length)]));
  const byChannel = new Map(channels.map(({ number, topic }) => [number, byTopic.get(topic)]));
  let number = 0;
  for (const { channel, targets, timeMs, record } of entries) {
    const isHeld = (targets & FLIGHT_TARGET) !== 0 && timeMs >= sinceMs && record.length > 0;
    const newest = isHeld ? byChannel.get(channel) : undefined;
    newest?.add({ number: number++, timeMs, record: record.slice() });
  }
  const found = [...byTopic.values()].flatMap((newest) => newest.list());
  return pack(found.sort((a, b) => a.timeMs - b.timeMs || a.number - b.number));
}

/** One piece of memory: an object for each record would take longer to hand to another thread than to find. */
function pack(found: readonly Found[]): FlightRecords {
  const lengths = found.map(({ record }) => record.length);
  const records = new Uint8Array(lengths.reduce((sum, length) => sum + length, 0));
  let at = 0;
  for (const { record } of found) {
    records.set(record, at);
    at += record.length;
  }
  return { timesMs: found.map(({ timeMs }) => timeMs), lengths, records };
}
