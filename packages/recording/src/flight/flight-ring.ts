import { describeRecord } from '../records/describe-record.ts';
import { MAX_JOINED_BYTES } from '../records/large-record.ts';
import type { RecordedRecord } from '../records/recorded-record.ts';
import type { RecordingEvent } from '../records/recording-event.ts';
import type { RecordingWriter } from '../writing/recording-writer.ts';
import { HeldEvents } from './held-events.ts';
import { isEnd, type Slab, type SlabChannel, type SlabEntry } from './slab.ts';
import { SlabChannels } from './slab-channels.ts';
import { SlabQueue } from './slab-queue.ts';
import { StandingValues } from './standing-values.ts';

/** Small records leave memory by slabs of this size, or of a 64th of all. */
const MAX_SLAB_BYTES = 256 * 1024;
const SLABS = 64;
/** Share of memory for values that stand when the window begins, and for events: an eighth each. */
const SHARE = 8;
const NS_PER_MS = 1_000_000;
/** In place of a record: the topic has no value any more. */
const END = new Uint8Array(0);

/** What a flight ring may hold. */
export interface FlightRingLimits {
  readonly maxMs: number;
  readonly maxBytes: number;
  /** Keep `image2D` and `image2DList`. */
  readonly withImages: boolean;
}

/** What a flight ring holds. */
export interface FlightRingContent {
  /** From the oldest record to the newest, milliseconds; at most `maxMs`. */
  readonly heldMs: number;
  /** Memory taken, bytes. */
  readonly heldBytes: number;
  readonly records: number;
  readonly topics: number;
}

/**
 * The last minutes in memory. The oldest records leave first. Large records (over 16 KiB) and small ones have half of
 * the memory each, and more only while the other half is not needed: pictures cannot push out everything else.
 */
export class FlightRing {
  #limits: FlightRingLimits;
  #channels = new SlabChannels();
  #small = new SlabQueue();
  #large = new SlabQueue();
  #standing = new StandingValues();
  #events = new HeldEvents();
  #newestNs = 0n;
  /** Time that has passed, as a log time; it runs on while nothing comes. */
  #nowNs = 0n;

  constructor(limits: FlightRingLimits) {
    this.#limits = limits;
  }

  get content(): FlightRingContent {
    const records = this.#small.records + this.#large.records;
    const heldNs = records === 0 ? 0 : Number(this.#newestNs - this.#startNs());
    return {
      heldMs: Math.max(0, heldNs) / NS_PER_MS,
      heldBytes: this.#small.bytes + this.#large.bytes + this.#standing.bytes + this.#events.bytes,
      records,
      topics: new Set([...this.#channels.topics, ...this.#standing.topics]).size,
    };
  }

  /** Log time after which the first of what is held is over; undefined when only standing values and states are held. [RC-35] */
  get nextEndNs(): bigint | undefined {
    const newest = [
      this.#small.oldest?.newestNs,
      this.#large.oldest?.newestNs,
      this.#events.oldestNs,
    ].filter((timeNs) => timeNs !== undefined);
    if (newest.length === 0) return undefined;
    return newest.reduce(minOf) + this.#lengthNs;
  }

  /** Lets time pass: what is over leaves. @param nowNs as a log time [RC-35] */
  advanceTo(nowNs: bigint): void {
    this.#nowNs = nowNs;
    this.#evict();
  }

  /** Keeps a record, a small one as a copy. Its bytes are not modified any more. */
  addRecord(record: RecordedRecord): void {
    if (!this.#limits.withImages && isImage(record.record)) return;
    // The clock was set back: what is held would stand in the future for hours.
    if (record.logTimeNs < this.#newestNs - this.#lengthNs) this.clear();
    this.#nowNs = record.logTimeNs;
    if (record.record.length <= MAX_JOINED_BYTES) this.#addSmall(record);
    else this.#large.keep(this.#channels.take(record), record);
    if (record.logTimeNs > this.#newestNs) this.#newestNs = record.logTimeNs;
    this.#evict();
  }

  addEvent(event: RecordingEvent): void {
    // A marker may stand for a moment to come; it leaves as one of now.
    const atNs = this.#presentNs > 0n ? minOf(event.timeNs, this.#presentNs) : event.timeNs;
    this.#events.add(event, atNs);
    this.#evict();
  }

  /** Changes limits; what exceeds them leaves at once. Images that are held stay. */
  setLimits(limits: FlightRingLimits): void {
    this.#limits = limits;
    this.#evict();
  }

  /** Notes that a topic has no value any more: it is forgotten when its records have left the window. */
  forget(topic: string): void {
    if (!this.#channels.hasTopic(topic) && !this.#standing.hasTopic(topic)) return;
    const timeNs = this.#presentNs;
    this.#addSmall({ topic, clientId: '', record: END, logTimeNs: timeNs, publishTimeNs: timeNs });
    this.#evict();
  }

  /** Forgets everything. */
  clear(): void {
    this.#channels = new SlabChannels();
    this.#small = new SlabQueue();
    this.#large = new SlabQueue();
    this.#standing = new StandingValues();
    this.#events = new HeldEvents();
    this.#newestNs = 0n;
    this.#nowNs = 0n;
  }

  /** Writes what is held now; values and states that are older and still stand are written at the beginning. */
  async writeTo(writer: RecordingWriter): Promise<void> {
    const startNs = this.#startNs();
    const channels = this.#channels.snapshot();
    const small = recordsOf(this.#small.entries(), channels);
    const large = recordsOf(this.#large.entries(), channels);
    const standing = new StandingValues();
    for (const record of this.#standing) standing.set(record);
    for (const event of this.#events) {
      const timeNs = event.timeNs < startNs ? startNs : event.timeNs;
      writer.addEvent({ ...event, timeNs });
    }
    let hasBegun = false;
    for (const record of merged(small, large)) {
      if (isEnd(record.record)) {
        if (record.logTimeNs <= startNs) standing.forget(record.topic);
      } else if (record.logTimeNs < startNs) standing.set(record);
      else {
        if (!hasBegun) await writeAt(startNs, standing, writer);
        hasBegun = true;
        await writer.addRecord(record);
      }
    }
    if (!hasBegun) await writeAt(startNs, standing, writer);
  }

  #addSmall(record: RecordedRecord): void {
    const slabBytes = Math.min(MAX_SLAB_BYTES, Math.floor(this.#limits.maxBytes / SLABS));
    this.#small.add(this.#channels.take(record), record, slabBytes);
  }

  /** Log time at which the window begins. */
  #startNs(): bigint {
    const oldest = [this.#small.oldest?.oldestNs, this.#large.oldest?.oldestNs]
      .filter((timeNs) => timeNs !== undefined)
      .reduce(minOf, this.#newestNs);
    const limit = this.#windowStartNs();
    return oldest > limit ? oldest : limit;
  }

  #windowStartNs(): bigint {
    return this.#presentNs - this.#lengthNs;
  }

  get #presentNs(): bigint {
    return this.#nowNs > this.#newestNs ? this.#nowNs : this.#newestNs;
  }

  get #lengthNs(): bigint {
    return BigInt(Math.round(this.#limits.maxMs * NS_PER_MS));
  }

  #evict(): void {
    const windowStartNs = this.#windowStartNs();
    for (const queue of [this.#small, this.#large]) {
      while (queue.oldest !== undefined && queue.oldest.newestNs < windowStartNs) {
        this.#release(queue.shift()!);
      }
    }
    const { maxBytes } = this.#limits;
    this.#events.expire(windowStartNs);
    this.#events.limit(maxBytes / SHARE);
    for (;;) {
      while (this.#standing.bytes > maxBytes / SHARE) this.#standing.forgetOldest();
      const available = maxBytes - this.#standing.bytes - this.#events.bytes;
      if (this.#small.bytes + this.#large.bytes <= available) return;
      const isLarge = this.#large.bytes > available / 2;
      this.#release((isLarge ? this.#large : this.#small).shift()!);
    }
  }

  #release(slab: Slab): void {
    const last = new Map<number, SlabEntry[1]>();
    const stand = (): void => {
      for (const [number, record] of last) {
        this.#standing.set({ ...this.#channels.get(number), ...record });
      }
      last.clear();
    };
    for (const [number, entry] of slab.entries()) {
      if (!isEnd(entry.record)) last.set(number, entry);
      else {
        stand();
        this.#standing.forget(this.#channels.get(number).topic);
      }
    }
    stand();
    for (const [number] of slab.entries()) this.#channels.release(number);
  }
}

function minOf(a: bigint, b: bigint): bigint {
  return a < b ? a : b;
}

function isImage(record: Uint8Array): boolean {
  const { format } = describeRecord(record);
  return format === 'image2D' || format === 'image2DList';
}

function* recordsOf(
  entries: Iterable<SlabEntry>,
  channels: ReadonlyMap<number, SlabChannel>,
): Generator<RecordedRecord> {
  for (const [number, record] of entries) yield { ...channels.get(number)!, ...record };
}

/** Merges two rows of records by log time. */
function* merged(
  first: Iterator<RecordedRecord>,
  second: Iterator<RecordedRecord>,
): Generator<RecordedRecord> {
  let a = first.next();
  let b = second.next();
  while (a.done !== true || b.done !== true) {
    if (b.done === true || (a.done !== true && a.value.logTimeNs <= b.value.logTimeNs)) {
      yield a.value as RecordedRecord;
      a = first.next();
    } else {
      yield b.value as RecordedRecord;
      b = second.next();
    }
  }
}

async function writeAt(
  logTimeNs: bigint,
  records: Iterable<RecordedRecord>,
  writer: RecordingWriter,
): Promise<void> {
  for (const record of records) await writer.addRecord({ ...record, logTimeNs });
}
