import { decode } from '@ubii/proto';
import type { StreamReceiver } from './load-connection.ts';
import type { RecordRing, Tape } from './record-ring.ts';
import { MAX_WINDOW } from './record-ring.ts';
import { WEB_SOCKET, type StreamReader, type Wire } from './wire.ts';

const TOPIC_DATA_RECORD_TAG = 0x12;
const RECORD_LIST_TAG = 0x1a;
const LIST_ELEMENT_TAG = 0x0a;

/** Delivery faults of one connection, in records. Zero and empty without faults. */
export interface DeliveryFaults {
  lost: number;
  altered: number;
  repeated: number;
  /** Unexpected messages: one sentence each, the first few only. */
  readonly unexpected: string[];
}

const MAX_SENTENCES = 5;

/**
 * Checks every byte a subscriber receives against what was published: each record once, in order,
 * unaltered.
 *
 * The expected stream is known before, so the usual case costs one memory comparison a chunk. Only
 * when it fails is the chunk taken apart frame by frame, to find out what is wrong (or that it is a
 * list, or a PING).
 */
export class DeliveryVerifier implements StreamReceiver {
  /** Number of the record expected next. Lost and altered ones count as over. */
  next = 0;
  readonly faults: DeliveryFaults = { lost: 0, altered: 0, repeated: 0, unexpected: [] };
  readonly #ring: RecordRing;
  /** The stream as it usually comes. */
  readonly #expected: Tape;
  readonly #reader: StreamReader;
  /** Bytes of a frame that has begun to match and is not complete. */
  #partialBytes = 0;

  onPing: () => void = () => {};
  /** Called after bytes were verified; `next` says how far the stream is. */
  onProgress: () => void = () => {};

  constructor(ring: RecordRing, wire: Wire = WEB_SOCKET) {
    this.#ring = ring;
    this.#expected = wire.delivered(ring);
    this.#reader = wire.openReader({
      handleTopicData: (bytes, start, end) => this.#handleTopicData(bytes, start, end),
      handlePing: () => this.onPing(),
      handleOther: (what) => this.#report(what),
    });
  }

  push(chunk: Buffer): void {
    this.#verify(chunk);
    this.onProgress();
  }

  handleEnd(reason: string): void {
    this.faults.unexpected.push(reason);
  }

  /** Counts what was published and has not come as lost. */
  finish(published: number): void {
    if (this.next > published) {
      this.#report(`${this.next - published} records arrived that were not published`);
    }
    this.faults.lost += Math.max(0, published - this.next);
  }

  #verify(chunk: Buffer): void {
    if (this.#reader.isAtBoundary) {
      const frames = this.#expected;
      const offset = frames.offsetOf(this.next) + this.#partialBytes;
      if (frames.matches(offset, chunk, 0, chunk.length)) {
        const bytes = this.#partialBytes + chunk.length;
        this.next += Math.floor(bytes / frames.stepBytes);
        this.#partialBytes = bytes % frames.stepBytes;
        return;
      }
      if (this.#partialBytes > 0) {
        const start = frames.offsetOf(this.next);
        this.#reader.push(frames.bytes.subarray(start, start + this.#partialBytes));
        this.#partialBytes = 0;
      }
    }
    this.#reader.push(chunk);
  }

  #handleTopicData(bytes: Buffer, start: number, end: number): void {
    const tag = bytes[start];
    if (tag === TOPIC_DATA_RECORD_TAG) {
      const record = delimitedAt(bytes, start, end);
      if (record?.end === end) return this.#handleRecord(bytes, record.start, end);
    } else if (tag === RECORD_LIST_TAG) {
      const list = delimitedAt(bytes, start, end);
      if (list?.end === end) return this.#handleList(bytes, list.start, end);
    }
    this.#report(`topic data that is no record: ${describe(bytes.subarray(start, end))}`);
  }

  #handleList(bytes: Buffer, start: number, end: number): void {
    const { elements } = this.#ring;
    const count = (end - start) / elements.stepBytes;
    if (
      Number.isInteger(count) &&
      elements.matches(elements.offsetOf(this.next), bytes, start, end)
    ) {
      this.next += count;
      return;
    }
    let at = start;
    while (at < end) {
      const element = bytes[at] === LIST_ELEMENT_TAG ? delimitedAt(bytes, at, end) : undefined;
      if (element === undefined) {
        this.#report(`a record list that breaks off after ${at - start} bytes`);
        return;
      }
      this.#handleRecord(bytes, element.start, element.end);
      at = element.end;
    }
  }

  #handleRecord(bytes: Buffer, start: number, end: number): void {
    for (let ahead = 0; ahead <= MAX_WINDOW; ahead += 1) {
      if (this.#isRecord(this.next + ahead, bytes, start, end)) {
        this.faults.lost += ahead;
        this.next += ahead + 1;
        return;
      }
    }
    for (let back = 1; back <= Math.min(MAX_WINDOW, this.next); back += 1) {
      if (this.#isRecord(this.next - back, bytes, start, end)) {
        this.faults.repeated += 1;
        return;
      }
    }
    this.faults.altered += 1;
    this.next += 1;
  }

  #isRecord(sequence: number, bytes: Buffer, start: number, end: number): boolean {
    const { elements, recordBytes } = this.#ring;
    if (end - start !== recordBytes) return false;
    const offset = elements.offsetOf(sequence) + elements.stepBytes - recordBytes;
    return elements.matches(offset, bytes, start, end);
  }

  #report(sentence: string): void {
    if (this.faults.unexpected.length < MAX_SENTENCES) this.faults.unexpected.push(sentence);
  }
}

/** Bounds of the length-delimited member whose tag is at `at`; undefined when it does not fit. */
function delimitedAt(
  bytes: Buffer,
  at: number,
  limit: number,
): { start: number; end: number } | undefined {
  let length = 0;
  let start = at + 1;
  for (let shift = 0; shift < 28; shift += 7) {
    const byte = bytes[start];
    if (byte === undefined) return undefined;
    start += 1;
    length |= (byte & 0x7f) << shift;
    if (byte < 0x80) {
      const end = start + length;
      return end <= limit ? { start, end } : undefined;
    }
  }
  return undefined;
}

function describe(payload: Uint8Array): string {
  try {
    const { error } = decode('ubii.topicData.TopicData', payload);
    if (error !== undefined) return `the error "${error.title}: ${error.message}"`;
  } catch {
    // Not topic data at all: the bytes are all there is to say.
  }
  return `${payload.length} bytes, ${Buffer.from(payload.subarray(0, 16)).toString('hex')}…`;
}
