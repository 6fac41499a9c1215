import { DecodeError, type ServiceErrorCode } from '@ubii/proto';
import { TopicDataScan, type TextCache, type TopicDataSink } from '@ubii/proto/wire';
import type { Cancel, Clock } from '@ubii/timing';
import type { LimitWatch } from '../counters/limit-watch.ts';
import type { ClientConnection } from '../ports/client-connection.ts';
import type { Log } from '../ports/log.ts';
import { Publication } from '../topics/publication.ts';
import { publish, type PublishContext } from '../topics/publisher.ts';
import { REFUSALS, type Refusal } from '../topics/refusals.ts';
import type { Client } from './client.ts';
import type { FrameSlices, SlicedFrames } from './frame-slices.ts';

/** Dependencies of incoming frames. */
export interface FrameContext extends PublishContext {
  readonly clock: Clock;
  readonly log: Log;
  readonly limitWatch: LimitWatch;
  /** Topics that came lately, of all clients. */
  readonly topicTexts: TextCache;
  readonly slices: FrameSlices;
}

/** The socket that frames come in on. */
export interface FrameOwner {
  readonly client: Client;
  readonly connection: Pick<ClientConnection, 'setReading'>;
  readonly isOpen: boolean;
  handleRefused(refusal: Refusal, publication: Publication): void;
  /** So many records were refused for the reason of the one before. */
  handleRestRefused(refusal: Refusal, count: number): void;
  handleProtocolError(reason: string): void;
  handleNodeMessage(bytes: Uint8Array): void;
  sendError(code: ServiceErrorCode, message: string): void;
  /** No frame waits any more. */
  handleAllRead(): void;
}

/*
 * Work of a slice: at most a millisecond or two, a small part of the 25 ms by which records of others may be late.
 * Nearly all frames are read in one slice.
 */
const SLICE_RECORDS = 1_024;
const SLICE_DELIVERIES = 8_192;
const SLICE_FIELDS = 32_768;

/** A shorter field counts as so many bytes of the rate: its check costs as much as that of a field of this length. */
const FIELD_BYTES = 16;
/** A shorter frame counts as so many: receiving it costs a few microseconds, as much as it takes to receive these. */
const FRAME_BYTES = 1_024;

const NO_BYTES = new Uint8Array(0);

/** Reads the frames of one client in order, large ones in slices. [TD-70] [TD-71] */
export class IncomingFrames implements SlicedFrames, TopicDataSink {
  readonly #context: FrameContext;
  readonly #owner: FrameOwner;
  readonly #publication = new Publication();
  /** Of the frame that is being read. */
  #scan: TopicDataScan | undefined = undefined;
  #records = 0;
  /** Why the rest of its records is refused. */
  #restRefusal: Refusal | undefined = undefined;
  /** Frames that came after it. */
  #queue: Uint8Array[] = [];
  /** Place of the next one among them. */
  #next = 0;
  #queuedBytes = 0;
  /** Of the slice that is being read. */
  #sliceRecords = 0;
  #sliceCaused = 0;
  #isReading = true;
  /** Ends the pause of a client that has sent more bytes than it may; undefined: there is none. */
  #cancelPause: Cancel | undefined = undefined;

  constructor(context: FrameContext, owner: FrameOwner) {
    this.#context = context;
    this.#owner = owner;
    this.#publication.client = owner.client;
  }

  /** A frame waits, or the rest of one. */
  get hasUnread(): boolean {
    return this.#scan !== undefined || this.#next < this.#queue.length;
  }

  /** Reads a frame, or the beginning of a large one. */
  handleFrame(bytes: Uint8Array): void {
    if (!this.#owner.isOpen) return this.#ignore(bytes);
    if (this.hasUnread) {
      this.#queue.push(bytes);
      this.#queuedBytes += bytes.byteLength;
    } else {
      this.#begin(bytes);
      // When its last sign came is now.
      if (this.readSlice(this.#owner.client.lastSignMs)) return;
      this.#context.slices.add(this);
    }
    this.#updateReading();
    const canPause = this.#owner.connection.setReading !== undefined;
    if (canPause && this.#queuedBytes <= this.#context.limits.frameBytes) return;
    while (!this.readSlice());
    this.#context.slices.remove(this);
  }

  /** Drops unread slices: the connection has ended. */
  discard(): void {
    this.#context.slices.remove(this);
    this.#cancelPause?.();
    this.#cancelPause = undefined;
    this.#clearQueue();
    this.#scan?.pause();
    this.#scan = undefined;
    this.#publication.frame = NO_BYTES;
    // The transport waits for the end of the other side.
    this.#updateReading();
  }

  readSlice(monotonicMs = this.#context.clock.monotonicMs()): boolean {
    const { client } = this.#owner;
    const publication = this.#publication;
    publication.monotonicMs = monotonicMs;
    publication.nowMs = this.#context.clock.nowMs();
    this.#sliceRecords = 0;
    this.#sliceCaused = client.traffic.recordsCaused;
    for (;;) {
      if (this.#scan !== undefined && !this.#readOn(this.#scan)) return false;
      const next = this.#queue[this.#next];
      if (next === undefined) break;
      if (this.#isSliceFull()) return false;
      this.#next++;
      this.#queuedBytes -= next.byteLength;
      this.#begin(next);
    }
    if (this.#next > 0) this.#clearQueue();
    if (!this.#isReading) {
      this.#updateReading();
      this.#owner.handleAllRead();
    }
    return true;
  }

  #begin(bytes: Uint8Array): void {
    const { publishLimits } = this.#owner.client;
    const { topicTexts } = this.#context;
    const publication = this.#publication;
    publication.frame = bytes;
    publication.start = 0;
    publication.end = bytes.byteLength;
    // A message without records is work as well.
    this.#sliceRecords++;
    const refusal = this.#refusalOf(bytes);
    if (refusal !== undefined) {
      this.#owner.handleRefused(refusal, publication);
      publication.frame = NO_BYTES;
      // It was received, which is work as well.
      publication.monotonicMs = this.#context.clock.monotonicMs();
      this.#charge(bytes.byteLength, 0);
      return;
    }
    this.#records = 0;
    this.#restRefusal = undefined;
    const maxMemberFields = publishLimits.recordFields.value;
    this.#scan = new TopicDataScan(bytes, { topics: topicTexts, maxMemberFields });
  }

  #refusalOf({ byteLength }: Uint8Array): Refusal | undefined {
    const { frameBytes, bytesPerSecond } = this.#owner.client.publishLimits;
    if (byteLength > frameBytes.value) return REFUSALS.largeFrame;
    // Over its rate, or never to be within it.
    const isOverRate = this.#cancelPause !== undefined || byteLength > bytesPerSecond.value;
    return isOverRate ? REFUSALS.tooManyBytes : undefined;
  }

  /** A frame that comes after the end: a client that sends many is not read until its transport gives it up. */
  #ignore({ byteLength }: Uint8Array): void {
    const { byteBudget } = this.#owner.client;
    const bytes = Math.max(byteLength, FRAME_BYTES);
    if (byteBudget.spend(bytes, this.#context.clock.monotonicMs())) return;
    this.#owner.connection.setReading?.(false);
  }

  /** @returns whether the frame was read to its end */
  #readOn(scan: TopicDataScan): boolean {
    try {
      if (!scan.run(this, SLICE_FIELDS)) return this.#scan === undefined;
    } catch (error) {
      if (error instanceof DecodeError) this.#owner.handleProtocolError(`${error.message}.`); // [TD-12]
      else this.#context.log.error('a record could not be published', { reason: String(error) });
    }
    // A protocol error may have closed the socket.
    if (this.#scan === undefined) return true;
    this.#scan = undefined;
    const publication = this.#publication;
    if (this.#restRefusal !== undefined) this.#countRest(this.#restRefusal, scan.skippedRecords);
    this.#charge(publication.frame.byteLength, scan.fields);
    publication.frame = NO_BYTES;
    publication.entry = undefined;
    return true;
  }

  #countRest(refusal: Refusal, count: number): void {
    const { throttle } = this.#owner.client;
    if (refusal === REFUSALS.throttled && throttle !== undefined) throttle.dropped += count; // [EX-32]
    this.#owner.handleRestRefused(refusal, count);
  }

  #charge(byteLength: number, fields: number): void {
    const { client } = this.#owner;
    const { bytesPerSecond } = client.publishLimits;
    const { monotonicMs } = this.#publication;
    // Never more than a pause of two seconds.
    const mostBytes = 2 * bytesPerSecond.value;
    const bytes = Math.min(mostBytes, Math.max(byteLength, fields * FIELD_BYTES, FRAME_BYTES));
    const isWithinRate = client.byteBudget.spend(bytes, monotonicMs);
    if (!isWithinRate && this.#cancelPause === undefined) this.#pause();
  }

  /** Reads nothing more until the bytes that were sent are within the rate. [TD-70] */
  #pause(): void {
    const { client } = this.#owner;
    const { name, value } = client.publishLimits.bytesPerSecond;
    this.#waitForRate();
    this.#updateReading();
    this.#context.limitWatch.count(name, client.id);
    this.#owner.sendError(
      'resource_exhausted',
      `This client sends more than ${value} bytes per second (limit ${name}), so the master reads its messages later. Send less, or smaller records.`,
    );
  }

  #waitForRate(): void {
    const { clock } = this.#context;
    const { byteBudget } = this.#owner.client;
    this.#cancelPause = clock.after(byteBudget.waitMs(clock.monotonicMs()), () => {
      this.#cancelPause = undefined;
      // What was received before the pause is paid for as well.
      if (byteBudget.waitMs(clock.monotonicMs()) > 0) this.#waitForRate();
      else this.#updateReading();
    });
  }

  /** Lets the transport read on, or lets it wait with what the client sends. */
  #updateReading(): void {
    const isReading = !this.hasUnread && this.#cancelPause === undefined;
    if (isReading === this.#isReading) return;
    this.#isReading = isReading;
    this.#owner.connection.setReading?.(isReading);
  }

  #clearQueue(): void {
    this.#queue = [];
    this.#next = 0;
    this.#queuedBytes = 0;
  }

  #isSliceFull(): boolean {
    const caused = this.#owner.client.traffic.recordsCaused - this.#sliceCaused;
    return this.#sliceRecords >= SLICE_RECORDS || caused >= SLICE_DELIVERIES;
  }

  // --- What the scan finds ---

  record(topic: string, start: number, end: number, valueField: number): void {
    const publication = this.#publication;
    publication.topic = topic;
    publication.start = start;
    publication.end = end;
    publication.valueField = valueField;
    this.#sliceRecords++;
    const refusal =
      ++this.#records > this.#owner.client.publishLimits.frameRecords.value
        ? REFUSALS.manyRecords
        : publish(this.#context, publication);
    if (refusal !== undefined) {
      this.#owner.handleRefused(refusal, publication);
      if (refusal.isForRest === true) {
        this.#restRefusal = refusal;
        this.#scan?.skipRecords();
      }
    }
    if (this.#isSliceFull()) this.#scan?.pause();
  }

  error(): void {
    // Nothing is asked of the master by a client's error.
  }

  nodeMessage(start: number, end: number): void {
    this.#owner.handleNodeMessage(this.#publication.frame.subarray(start, end));
  }
}
