import { encodeRecord } from '@ubii/proto';
import { OPCODE, clientFrame, serverFrame } from './frames.ts';

const TOPIC_DATA_RECORD_TAG = 0x12;
const LIST_ELEMENT_TAG = 0x0a;

/** Fixed, so that every record has the same length and every run the same bytes. */
const TIMESTAMP_MS = 1_750_000_000_000;

/** Different records before the ring starts again. Far more than can be under way at once. */
export const RING_RECORDS = 8192;

/** Records repeated behind the end of the ring, so that what is under way is always one slice. */
const OVERLAP_RECORDS = 256;

/** The most records that may be under way at once: a chunk that holds them all is one slice. */
export const MAX_WINDOW = OVERLAP_RECORDS / 2;

/** Bytes that repeat every `size` records, with one fixed length a record. */
export class Tape {
  readonly bytes: Buffer;
  readonly stepBytes: number;
  readonly #size: number;

  /** @param steps the bytes of each record, all of one length */
  constructor(steps: readonly Uint8Array[]) {
    this.stepBytes = steps[0]?.length ?? 0;
    if (steps.some((step) => step.length !== this.stepBytes)) {
      throw new RangeError('Expected records of one length.');
    }
    this.#size = steps.length;
    this.bytes = Buffer.concat([...steps, ...steps.slice(0, OVERLAP_RECORDS)]);
  }

  /** Bytes of each record before the tape begins again. */
  *steps(): Iterable<Buffer> {
    for (let step = 0; step < this.#size; step += 1) yield this.slice(step, 1);
  }

  /** Offset of record number `sequence` in `bytes`. */
  offsetOf(sequence: number): number {
    return (sequence % this.#size) * this.stepBytes;
  }

  /** The bytes of `count` records from number `sequence` on; at most `MAX_WINDOW`. */
  slice(sequence: number, count: number): Buffer {
    const start = this.offsetOf(sequence);
    return this.bytes.subarray(start, start + count * this.stepBytes);
  }

  /** True when `chunk[start, end)` is what the tape holds from `offset` on. */
  matches(offset: number, chunk: Buffer, start: number, end: number): boolean {
    const upTo = offset + end - start;
    return upTo <= this.bytes.length && this.bytes.compare(chunk, start, end, offset, upTo) === 0;
  }
}

/** Everything that is sent and expected in one workload, encoded before the clock runs. */
export interface RecordRing {
  readonly topic: string;
  /** Length of one encoded TopicDataRecord, bytes. */
  readonly recordBytes: number;
  /** TopicData with one record each. */
  readonly messages: Tape;
  /** Masked frames, each one TopicData with one record. */
  readonly published: Tape;
  /** Frames as a broker sends them that passes on what was published. */
  readonly frames: Tape;
  /** Elements of a TopicDataRecordList, tag and length included. */
  readonly elements: Tape;
}

function delimited(tag: number, bytes: Uint8Array): Buffer {
  const head = [tag];
  let length = bytes.length;
  for (; length > 0x7f; length >>>= 7) head.push((length & 0x7f) | 0x80);
  return Buffer.concat([Buffer.from([...head, length]), bytes]);
}

/**
 * Records of `recordBytes` bytes (topic, timestamp, vector3), each with its sequence number in `x`.
 *
 * @throws RangeError when the size cannot be met.
 */
export function createRecordRing(name: string, recordBytes = 100, size = RING_RECORDS): RecordRing {
  const encode = (topic: string, sequence: number): Uint8Array =>
    encodeRecord({
      topic,
      format: 'vector3',
      value: { x: sequence, y: Math.sin(sequence), z: Math.cos(sequence) },
      timestampMs: TIMESTAMP_MS,
    });
  const stem = `/benchmark/${name}/`;
  const padding = recordBytes - encode(stem, 0).length;
  if (padding < 0) throw new RangeError(`Expected room for the topic ${stem} in ${recordBytes} B.`);
  const topic = stem + 'x'.repeat(padding);
  return ringOf(
    topic,
    Array.from({ length: size }, (_, sequence) => encode(topic, sequence)),
  );
}

/**
 * Compressed pictures of `pictureBytes` bytes, each different. @param size at least twice as many as are under way at
 * once
 */
export function createPictureRing(name: string, pictureBytes: number, size: number): RecordRing {
  const topic = `/benchmark/${name}`;
  const pictures = Array.from({ length: size }, (_, sequence) => {
    const data = new Uint8Array(pictureBytes);
    for (let at = 0; at < pictureBytes; at += 1) data[at] = (at * 31 + sequence * 7) & 0xff;
    const value = { data };
    return encodeRecord({ topic, format: 'image2D', value, timestampMs: TIMESTAMP_MS });
  });
  return ringOf(topic, pictures);
}

/** @param records all of one length */
function ringOf(topic: string, records: readonly Uint8Array[]): RecordRing {
  const messages = records.map((record) => delimited(TOPIC_DATA_RECORD_TAG, record));
  return {
    topic,
    recordBytes: records[0]!.length,
    messages: new Tape(messages),
    published: new Tape(messages.map((message) => clientFrame(OPCODE.binary, message))),
    frames: new Tape(messages.map((message) => serverFrame(message))),
    elements: new Tape(records.map((record) => delimited(LIST_ELEMENT_TAG, record))),
  };
}
