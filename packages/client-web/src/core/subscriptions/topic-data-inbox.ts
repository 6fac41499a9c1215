import { DecodeError, ServiceError, decodeTopicData } from '@ubii/proto';
import type { EncodedNodeMessage } from '@ubii/proto/wire';
import { ClassicDuplicates } from './classic-duplicates.ts';
import { ReceivedRecord } from './received-record.ts';
import { scanFrame } from './scan-frame.ts';
import type { ScannedFrame } from './scan-frame.ts';

/** Callbacks of the inbox. */
export interface TopicDataInboxOptions {
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
