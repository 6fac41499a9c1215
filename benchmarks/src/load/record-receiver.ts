import { decodeTopicData, type EmptyRecord, type TopicRecord } from '@ubii/proto';
import { FrameReader, OPCODE } from './frames.ts';
import type { StreamReceiver } from './load-connection.ts';

const TEXT_PING = 'PING';
const MAX_SENTENCES = 5;

/** Takes the records a broker sends one by one, with what they hold. */
export class RecordReceiver implements StreamReceiver {
  /** Unexpected messages: one sentence each, the first few only. */
  readonly faults: string[] = [];
  onPing: () => void = () => {};
  /** Called for each frame of topic data, before it is read. */
  onFrame: () => void = () => {};
  /** Called for each record in it. */
  onRecord: (record: TopicRecord | EmptyRecord) => void = () => {};
  /** Called when there is no hope for more. */
  onEnd: (reason: string) => void = () => {};
  readonly #reader = new FrameReader((opcode, bytes, start, end) => {
    if (opcode === OPCODE.binary) this.#handleTopicData(bytes.subarray(start, end));
    else if (bytes.toString('latin1', start, end) === TEXT_PING) this.onPing();
    else this.#report(`a frame with opcode ${opcode} and ${end - start} bytes`);
  });

  push(chunk: Buffer): void {
    this.#reader.push(chunk);
  }

  handleEnd(reason: string): void {
    this.#report(reason);
    this.onEnd(reason);
  }

  #handleTopicData(bytes: Uint8Array): void {
    this.onFrame();
    const { records, error, failed } = decodeTopicData(bytes);
    if (error !== undefined) this.#report(`the error "${error.title}: ${error.message}"`);
    for (const { message } of failed) this.#report(`a record that cannot be read: ${message}`);
    for (const record of records) this.onRecord(record);
  }

  #report(sentence: string): void {
    if (this.faults.length < MAX_SENTENCES) this.faults.push(`unexpected: ${sentence}`);
  }
}
