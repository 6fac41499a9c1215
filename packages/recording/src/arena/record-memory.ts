import { Channels, StandingValues, type Channel, type ChannelSource } from './channels.ts';
import {
  FLIGHT_TARGET,
  spansFrom,
  type RecordSpans,
  type SharedRecords,
} from './shared-records.ts';
import { RingWriter, type ReleasedEntry, type ReleaseListener } from './ring-writer.ts';

/** Records of more bytes are large. */
const MAX_SMALL_BYTES = 16 * 1024;
/** Share of the memory of the flight recorder for values that stand when the window begins: an eighth. */
const SHARE = 8;
/** In place of a record: the topic has no value any more. */
const END = new Uint8Array(0);
/** Bytes that leave at once when they are over: more would hold everything else up. */
const EXPIRED_BYTES = 256 * 1024;
const NO_LENGTH = -1;

/** Bytes that records may take. */
export interface MemoryBounds {
  /** Of the flight recorder; 0: it keeps nothing. */
  readonly flightBytes: number;
  /** On their way into files: the newest overwrite what was not read in time. [RC-19] */
  readonly queueBytes: number;
}

/** Records that were overwritten on their way into files. */
export interface Loss {
  readonly fromMs: number;
  untilMs: number;
  records: number;
}

/**
 * Memory with the last records, which other threads read: to keep what the flight recorder holds, and to write recordings. A
 * record costs its copy. Large records (over 16 KiB) have a ring of their own, with half of the memory: pictures cannot push out everything else.
 */
export class RecordMemory {
  readonly shared: SharedRecords;
  readonly channels = new Channels();
  readonly standing = new StandingValues();
  readonly #small: RingWriter;
  readonly #large: RingWriter;
  readonly #head = { channel: 0, targets: 0, timeMs: 0, order: 0 };
  /** Channels of the entries that leave now. */
  #leaving: Channel[] = [];
  readonly #losses = new Map<number, Loss>();
  #readTo = { small: 0, large: 0 };
  #bounds: MemoryBounds;
  /** Bytes that the flight recorder needs for other things. */
  #othersBytes = 0;
  #isWritingFiles = false;

  constructor(bounds: MemoryBounds) {
    this.#bounds = bounds;
    const capacity = Math.max(bounds.flightBytes, bounds.queueBytes);
    this.#small = new RingWriter(capacity, this.#listenerOf('small'));
    this.#large = new RingWriter(capacity / 2, this.#listenerOf('large'));
    this.shared = { small: this.#small.memory, large: this.#large.memory };
  }

  get bounds(): MemoryBounds {
    return this.#bounds;
  }

  /** All that is held. */
  get spans(): RecordSpans {
    return { small: this.#small.span, large: this.#large.span };
  }

  get heldBytes(): number {
    return this.#small.heldBytes + this.#large.heldBytes + this.standing.bytes;
  }

  /** Records that are held; ends of topics aside. */
  get records(): number {
    return this.#small.records + this.#large.records;
  }

  /** Time of the oldest record, epoch milliseconds; undefined without records. */
  get oldestMs(): number | undefined {
    const small = this.#small.oldestMs;
    const large = this.#large.oldestMs;
    if (small === undefined || large === undefined) return small ?? large;
    return Math.min(small, large);
  }

  /** Copies a record. @returns false when it is too large to be kept at all */
  add(source: ChannelSource, record: Uint8Array, timeMs: number, targets: number): boolean {
    const channel = this.channels.take(source);
    const available = this.#availableBytes();
    const isLarge = record.length > MAX_SMALL_BYTES;
    channel.held++;
    const head = this.#head;
    head.channel = channel.number;
    head.targets = targets;
    head.timeMs = timeMs;
    head.order++;
    const isKept = isLarge
      ? this.#large.add(record, head, available / 2)
      : this.#small.add(record, head, available - this.#large.heldBytes);
    if (isLarge) this.#small.limitTo(available - this.#large.heldBytes);
    if (isKept) return true;
    channel.held--;
    this.#dropUnused(channel);
    this.#lose(targets, timeMs);
    return false;
  }

  /** Notes that a topic has no value any more: it is forgotten when its records have left. [RC-33] */
  endTopic(topic: string, timeMs: number): void {
    if (!this.channels.hasTopic(topic)) return;
    this.add({ topic, clientId: '', channel: undefined }, END, timeMs, FLIGHT_TARGET);
  }

  /** Lets some of the records leave that are older than a moment, and overwrites them. @returns whether there are more [RC-35] */
  expire(beforeMs: number): boolean {
    const isMoreSmall = this.#small.expire(beforeMs, EXPIRED_BYTES);
    return this.#large.expire(beforeMs, EXPIRED_BYTES) || isMoreSmall;
  }

  /** @param bytes that the flight recorder needs for other things than records */
  reserve(bytes: number): void {
    this.#othersBytes = bytes;
    this.#limit();
  }

  /** Whether records go into files: those that were not read have the room of the queue. */
  writeFiles(isWriting: boolean): void {
    this.#isWritingFiles = isWriting;
    this.#limit();
  }

  /** Notes which records were read for files. */
  markRead({ small, large }: RecordSpans): void {
    this.#readTo = { small: small.to, large: large.to };
  }

  /** Records written since then. */
  since(read: RecordSpans): RecordSpans {
    return spansFrom(this.spans, read);
  }

  /** Records that were lost on their way into files, by targets, once. */
  takeLosses(): ReadonlyMap<number, Loss> {
    const losses = new Map(this.#losses);
    this.#losses.clear();
    return losses;
  }

  #availableBytes(): number {
    const { flightBytes, queueBytes } = this.#bounds;
    const ofFlight = flightBytes - this.standing.bytes - this.#othersBytes;
    return this.#isWritingFiles && queueBytes > ofFlight ? queueBytes : Math.max(0, ofFlight);
  }

  #limit(): void {
    const available = this.#availableBytes();
    this.#large.limitTo(available / 2);
    this.#small.limitTo(available - this.#large.heldBytes);
  }

  #listenerOf(ring: 'small' | 'large'): ReleaseListener {
    return {
      release: (entry) => this.#release(entry, this.#readTo[ring]),
      settle: (bytes) => this.#settle(bytes),
    };
  }

  #release(entry: ReleasedEntry, readTo: number): void {
    const { targets, length, timeMs } = entry;
    const channel = this.channels.get(entry.channel);
    channel.held--;
    const ofFiles = targets & ~FLIGHT_TARGET;
    if (ofFiles !== 0 && entry.position >= readTo) this.#lose(ofFiles, timeMs);
    this.#leave(channel);
    if ((targets & FLIGHT_TARGET) === 0) return;
    if (length === 0) return this.#forgetTopic(channel.topic);
    channel.leavingOffset = entry.offset;
    channel.leavingLength = length;
    channel.leavingMs = timeMs;
  }

  #leave(channel: Channel): void {
    if (channel.isLeaving) return;
    channel.isLeaving = true;
    channel.leavingLength = NO_LENGTH;
    this.#leaving.push(channel);
  }

  #forgetTopic(topic: string): void {
    for (const channel of this.channels.ofTopic(topic)) {
      this.standing.delete(channel);
      this.#leave(channel);
      channel.leavingLength = NO_LENGTH;
    }
  }

  /** Copies the last value of each channel of which something leaves. */
  #settle(bytes: Uint8Array): void {
    for (const channel of this.#leaving) {
      const { leavingOffset, leavingLength, leavingMs } = channel;
      if (leavingLength !== NO_LENGTH) {
        const record = bytes.subarray(leavingOffset, leavingOffset + leavingLength);
        this.standing.set(channel, leavingMs, record);
      }
      channel.isLeaving = false;
      this.#dropUnused(channel);
    }
    this.#leaving = [];
    for (const channel of this.standing.limitTo(this.#bounds.flightBytes / SHARE)) {
      this.#dropUnused(channel);
    }
  }

  #dropUnused(channel: Channel): void {
    if (channel.held === 0 && !channel.isGone && !this.standing.has(channel)) {
      this.channels.drop(channel);
    }
  }

  #lose(targets: number, timeMs: number): void {
    const loss = this.#losses.get(targets);
    if (loss === undefined) {
      this.#losses.set(targets, { fromMs: timeMs, untilMs: timeMs, records: 1 });
    } else {
      loss.untilMs = timeMs;
      loss.records++;
    }
  }
}
