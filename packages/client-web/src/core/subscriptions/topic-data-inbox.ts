import { ServiceError, decode, DecodeError, decodeTopicData } from '@ubii/proto';
import {
  TextCache,
  readNodeMessage,
  scanTopicData,
  type EncodedNodeMessage,
} from '@ubii/proto/wire';
import { ReceivedRecord } from './received-record.ts';

/**
 * An original master sends a record once for each subscription that matches its topic, the copies
 * directly after each other. This leaves the first of each and tells the others apart from a value
 * that was really published again: no more frames are copies than there are subscriptions.
 */
export class ClassicDuplicates {
  #last: Uint8Array | undefined;
  #copiesLeft = 0;

  /**
   * Whether the frame is a copy of the one before.
   * @param keptFrame must not be changed later
   * @param subscriptionCount how many subscriptions at the master match its topic
   */
  isCopy(keptFrame: Uint8Array, subscriptionCount: number): boolean {
    if (this.#copiesLeft > 0 && this.#last !== undefined && isEqual(this.#last, keptFrame)) {
      this.#copiesLeft -= 1;
      return true;
    }
    this.#last = keptFrame;
    this.#copiesLeft = Math.max(0, subscriptionCount - 1);
    return false;
  }
}

function isEqual(a: Uint8Array, b: Uint8Array): boolean {
  if (a.byteLength !== b.byteLength) return false;
  for (let i = 0; i < a.byteLength; i++) if (a[i] !== b[i]) return false;
  return true;
}

/** From this size a buffer is worth transferring instead of copying, bytes. */
const TRANSFERABLE_BYTES = 16 * 1024;

/** Content of a frame, with encoded records. */
interface ScannedFrame {
  readonly records: readonly ReceivedRecord[];
  readonly errors: readonly ServiceError[];
  readonly nodeMessages: readonly EncodedNodeMessage[];
}

interface Bounds {
  readonly topic: string;
  readonly start: number;
  readonly end: number;
  readonly valueField: number;
}

/** Topics come with every record. */
const topics = new TextCache();

/**
 * Takes a frame apart without decoding its records. A large record stays where it is, so that its
 * bytes are not copied; the frame's buffer goes with it when it is the only one. Small records beside
 * others are copied, so that a kept record does not keep the frame.
 *
 * @param keptFrame must not be changed later
 * @throws DecodeError when anything in it is broken
 */
function scanFrame(keptFrame: Uint8Array): ScannedFrame {
  const found: Bounds[] = [];
  const errors: ServiceError[] = [];
  const nodeMessages: EncodedNodeMessage[] = [];
  scanTopicData(
    keptFrame,
    {
      record: (topic, start, end, valueField) => void found.push({ topic, start, end, valueField }),
      error: (start, end) => {
        const error = decode('ubii.general.Error', keptFrame.subarray(start, end));
        errors.push(ServiceError.fromWire(error));
      },
      nodeMessage: (start, end) =>
        void nodeMessages.push(readNodeMessage(keptFrame.subarray(start, end))),
    },
    topics,
  );
  const largeCount = found.filter(isLarge).length;
  const ownsBuffer = largeCount === 1 && nodeMessages.length === 0 && holdsWholeBuffer(keptFrame);
  const records = found.map((bounds) => {
    const { topic, start, end, valueField } = bounds;
    const stays = isLarge(bounds) || found.length === 1;
    const bytes = stays ? keptFrame.subarray(start, end) : keptFrame.slice(start, end);
    return ReceivedRecord.fromEncoded(topic, bytes, valueField, ownsBuffer && isLarge(bounds));
  });
  return { records, errors, nodeMessages };
}

function isLarge({ start, end }: Bounds): boolean {
  return end - start >= TRANSFERABLE_BYTES;
}

/** A frame that is a part of a larger buffer has no right to give that away. */
function holdsWholeBuffer({ byteOffset, byteLength, buffer }: Uint8Array): boolean {
  return byteOffset === 0 && byteLength === buffer.byteLength && buffer instanceof ArrayBuffer;
}

/** Callbacks of the inbox. */
interface TopicDataInboxOptions {
  readonly handleRecord: (record: ReceivedRecord) => void;
  readonly handleNodeMessage: (message: EncodedNodeMessage) => void;
  /** True when there are receivers of encoded records or node messages. */
  readonly takesEncoded: () => boolean;
  /** Something in a frame cannot be decoded, or the master refused something. */
  readonly handleProblem: (problem: DecodeError | ServiceError) => void;
  /** Returns the number of subscriptions on the master that match a topic. */
  readonly countAtMaster: (topic: string) => number;
}

/** Makes records of the frames that arrive. What is broken is counted and told, and loses nothing else. */
export class TopicDataInbox {
  readonly #options: TopicDataInboxOptions;
  /** With an original master only. */
  #duplicates: ClassicDuplicates | undefined;
  recordsIn = 0;
  bytesIn = 0;
  decodeErrors = 0;

  constructor(options: TopicDataInboxOptions) {
    this.#options = options;
  }

  /** A master was met; an original one sends a record once per subscription. */
  handleMaster(isExtended: boolean): void {
    this.#duplicates = isExtended ? undefined : new ClassicDuplicates();
  }

  handleBinary(keptFrame: Uint8Array): void {
    this.bytesIn += keptFrame.byteLength;
    const scanned = this.#options.takesEncoded() ? this.#scan(keptFrame) : undefined;
    if (scanned === undefined) this.#decode(keptFrame);
    else {
      for (const record of scanned.records) this.#handleRecord(keptFrame, record);
      for (const message of scanned.nodeMessages) this.#options.handleNodeMessage(message);
      for (const error of scanned.errors) this.#options.handleProblem(error);
    }
  }

  /** `undefined` when anything in the frame is broken: decoding finds what is not. */
  #scan(keptFrame: Uint8Array): ScannedFrame | undefined {
    try {
      return scanFrame(keptFrame);
    } catch (error) {
      if (error instanceof DecodeError) return undefined;
      throw error;
    }
  }

  #decode(keptFrame: Uint8Array): void {
    const { records, error, failed } = decodeTopicData(keptFrame);
    for (const record of records) {
      this.#handleRecord(keptFrame, ReceivedRecord.fromDecoded(record));
    }
    if (error !== undefined) this.#options.handleProblem(ServiceError.fromWire(error));
    for (const problem of failed) this.#handleDecodeError(problem);
  }

  #handleRecord(keptFrame: Uint8Array, record: ReceivedRecord): void {
    this.recordsIn += 1;
    if (this.#duplicates?.isCopy(keptFrame, this.#options.countAtMaster(record.topic))) return;
    this.#options.handleRecord(record);
  }

  handleUnknownText(text: string): void {
    const shown = text.length > 40 ? `${text.slice(0, 40)}...` : text;
    this.#handleDecodeError(
      new DecodeError(
        'ubii.topicData.TopicData',
        text.length,
        `a text frame that is neither PING nor PONG: ${JSON.stringify(shown)}`,
      ),
    );
  }

  #handleDecodeError(problem: DecodeError): void {
    this.decodeErrors += 1;
    this.#options.handleProblem(problem);
  }
}
