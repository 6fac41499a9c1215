import { DecodeError, ServiceError, decodeTopicData } from '@ubii/proto';
import type { TopicRecord } from '@ubii/proto';
import { ClassicDuplicates } from './classic-duplicates.ts';

/** Whom the inbox tells. */
export interface TopicDataInboxOptions {
  readonly handleRecord: (record: TopicRecord) => void;
  /** Something in a frame cannot be decoded, or the master refused something. */
  readonly handleProblem: (problem: DecodeError | ServiceError) => void;
  /** How many subscriptions at the master match a topic. */
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
    const { records, error, failed } = decodeTopicData(keptFrame);
    for (const record of records) {
      this.recordsIn += 1;
      if (this.#duplicates?.isCopy(keptFrame, this.#options.countAtMaster(record.topic))) continue;
      // A record without a value says nothing that a subscription could hand on. [TD-13]
      if (record.format !== undefined) this.#options.handleRecord(record);
    }
    if (error !== undefined) this.#options.handleProblem(ServiceError.fromWire(error));
    for (const problem of failed) this.#handleDecodeError(problem);
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
