import { encodeRecordListFrame, recordFrameHeader } from '@ubii/proto/wire';
import type { Cancel, Clock } from '@ubii/timing';

/** Options for publishing a record. */
export interface PublishOptions {
  /** Send at once, with what is waiting before it, and not with the next flush. @default false */
  readonly immediate?: boolean;
  /** Timestamp of the record: milliseconds since the Unix epoch. @default now */
  readonly timestampMs?: number;
  /** Whether timestamps are in the time of the master, or in that of this machine. [TS-9] @default as `ClientOptions` say */
  readonly stampInMasterTime?: boolean;
  /**
   * Time for which the master keeps the value after this client left or was lost, whole seconds; at most one hour, and
   * less when its share of the memory is needed. [TD-43] @default 0, not at all
   */
  readonly keepSeconds?: number;
  /**
   * Expiry of the value on the master without a newer record of the topic, whole milliseconds: for values that are not
   * needed later, or that must not stay, such as pictures of a camera. [TD-47] @default 0, no expiry
   */
  readonly expiryMs?: number;
}

/** Receives frames. */
export interface PublishSink {
  /** Whether frames can be handed over at all. */
  readonly isOpen: boolean;
  /** Bytes handed over and not yet taken by the system. */
  readonly bufferedBytes: number;
  /** Sends a frame of so many records. The bytes are not used again. */
  send(frame: Uint8Array, recordCount: number): void;
}

/** A record that waits. */
export interface WaitingRecord {
  readonly topic: string;
  /** The encoded `TopicDataRecord`. */
  readonly bytes: Uint8Array;
  /** Events are not replaced by newer ones of their topic while the socket is full. */
  readonly isEvent: boolean;
}

/** The limits of what waits. */
export const PUBLISH_LIMITS = {
  /**
   * With more than this in the socket nothing is handed over. What is there cannot be taken back, so
   * it is what an interactive client is late by: 0.2 s at 20 Mbit/s.
   */
  socketFullBytes: 512 * 1024,
  /** While the socket is full it is looked at this often, milliseconds: WebSocket has no event for it. */
  socketPollMs: 4,
  /** Records of one frame may take this much, except for a single larger one. */
  frameBytes: 256 * 1024,
  /** Events of one topic that wait while the socket is full; the oldest is dropped. */
  waitingEventsPerTopic: 256,
  /** Topics of which the newest record is kept while there is no connection; the oldest is dropped. */
  awayTopics: 1_000,
  /** All that waits, however it came to wait; the oldest is dropped, a single larger record is not. */
  waitingBytes: 16 * 1024 * 1024,
  /** As soon as this many records wait they are sent, or thinned out, without waiting for the interval. */
  recordsAtOnce: 4_096,
} as const;

/**
 * Collects records and sends them as few frames, in the order they were published.
 *
 * - Socket takes them: everything leaves at the next flush; the first record after a pause leaves at
 *   the end of the turn, later ones at most `intervalMs` after the flush before.
 * - Socket full: the newest record of a topic replaces the waiting one; events all wait, up to a bound.
 * - No connection: only the newest record of each topic is kept, events too, because what happened
 *   without a connection is out of date; sent by `flush()` after the reconnect.
 *
 * Records that are replaced or over a limit are counted.
 */
export class PublishBuffer {
  readonly #clock: Clock;
  readonly #sink: PublishSink;
  #intervalMs: number;
  #waiting: WaitingRecord[] = [];
  #waitingBytes = 0;
  /** Records that wait before a flush is due at once; grows with what could not be sent, so that thinning out stays cheap. */
  #muchRecords: number = PUBLISH_LIMITS.recordsAtOnce;
  #dropped = 0;
  #lastFlushMs = -Infinity;
  #cancelFlush: Cancel | undefined;
  #isFlushingSoon = false;

  constructor(clock: Clock, sink: PublishSink, intervalMs: number) {
    this.#clock = clock;
    this.#sink = sink;
    this.#intervalMs = checkInterval(intervalMs);
  }

  /** Records that were not sent. */
  get dropped(): number {
    return this.#dropped;
  }

  /** Bytes of the records that wait. */
  get waitingBytes(): number {
    return this.#waitingBytes;
  }

  setIntervalMs(intervalMs: number): void {
    this.#intervalMs = checkInterval(intervalMs);
    if (this.#cancelFlush === undefined) return;
    this.#cancelFlush();
    this.#cancelFlush = undefined;
    this.#schedule();
  }

  add(record: WaitingRecord, isImmediate: boolean): void {
    this.#waiting.push(record);
    this.#waitingBytes += record.bytes.byteLength;
    const isMuch =
      this.#waiting.length >= this.#muchRecords ||
      this.#waitingBytes > 1.25 * PUBLISH_LIMITS.waitingBytes;
    if (isImmediate || isMuch) this.flush();
    else this.#schedule();
  }

  /** Sends what waits at the end of this turn. */
  flushSoon(): void {
    if (this.#isFlushingSoon) return;
    this.#isFlushingSoon = true;
    void Promise.resolve().then(() => {
      this.#isFlushingSoon = false;
      this.flush();
    });
  }

  /** Sends what waits, as far as the socket takes it. */
  flush(): void {
    this.#cancelFlush?.();
    this.#cancelFlush = undefined;
    if (this.#waiting.length === 0) return;
    if (!this.#sink.isOpen) {
      this.#thinOut(1, PUBLISH_LIMITS.awayTopics);
      return;
    }
    this.#lastFlushMs = this.#clock.monotonicMs();
    this.#send();
    this.#muchRecords = PUBLISH_LIMITS.recordsAtOnce;
    if (this.#waiting.length > 0) {
      this.#thinOut(PUBLISH_LIMITS.waitingEventsPerTopic, Infinity);
      this.#cancelFlush = this.#clock.after(PUBLISH_LIMITS.socketPollMs, () => this.flush());
    }
  }

  /** Drops what waits and stops. */
  clear(): void {
    this.#cancelFlush?.();
    this.#cancelFlush = undefined;
    this.#dropped += this.#waiting.length;
    this.#waiting = [];
    this.#waitingBytes = 0;
  }

  #schedule(): void {
    if (this.#cancelFlush !== undefined) return;
    const sinceLastMs = this.#clock.monotonicMs() - this.#lastFlushMs;
    const delayMs = Math.max(0, this.#intervalMs - sinceLastMs);
    this.#cancelFlush = this.#clock.after(delayMs, () => this.flush());
  }

  #send(): void {
    let sent = 0;
    while (
      sent < this.#waiting.length &&
      this.#sink.bufferedBytes <= PUBLISH_LIMITS.socketFullBytes
    ) {
      const records: Uint8Array[] = [];
      let bytes = 0;
      do {
        const record = this.#waiting[sent]!.bytes;
        if (bytes > 0 && bytes + record.byteLength > PUBLISH_LIMITS.frameBytes) break;
        records.push(record);
        bytes += record.byteLength;
        sent += 1;
      } while (sent < this.#waiting.length);
      this.#sink.send(frameOf(records), records.length);
      this.#waitingBytes -= bytes;
    }
    this.#waiting = sent === this.#waiting.length ? [] : this.#waiting.slice(sent);
  }

  /** Keeps the newest records: one state a topic, the given number of events; then applies the limits. */
  #thinOut(eventsPerTopic: number, maxRecords: number): void {
    const counts = new Map<string, number>();
    const kept: WaitingRecord[] = [];
    let keptBytes = 0;
    for (let i = this.#waiting.length - 1; i >= 0; i--) {
      const record = this.#waiting[i]!;
      const newer = counts.get(record.topic) ?? 0;
      if (newer >= (record.isEvent ? eventsPerTopic : 1)) continue;
      const isOver =
        kept.length >= maxRecords ||
        (kept.length > 0 && keptBytes + record.bytes.byteLength > PUBLISH_LIMITS.waitingBytes);
      if (isOver) break;
      counts.set(record.topic, newer + 1);
      kept.push(record);
      keptBytes += record.bytes.byteLength;
    }
    this.#dropped += this.#waiting.length - kept.length;
    this.#waiting = kept.reverse();
    this.#waitingBytes = keptBytes;
    this.#muchRecords = kept.length + PUBLISH_LIMITS.recordsAtOnce;
  }
}

function frameOf(records: readonly Uint8Array[]): Uint8Array {
  const [only] = records;
  if (records.length !== 1 || only === undefined) return encodeRecordListFrame(records);
  const header = recordFrameHeader(only.byteLength);
  const frame = new Uint8Array(header.byteLength + only.byteLength);
  frame.set(header);
  frame.set(only, header.byteLength);
  return frame;
}

function checkInterval(intervalMs: number): number {
  if (intervalMs >= 0 && Number.isFinite(intervalMs)) return intervalMs;
  throw new RangeError(`Expected a publish interval of 0 ms or more, received ${intervalMs}`);
}
