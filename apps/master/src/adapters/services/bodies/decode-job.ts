import type { MessagePort } from 'node:worker_threads';

import type { FormatName } from '../service-format.ts';

/** Initial data of the decoding thread. */
export interface DecodeThreadData {
  /** Receives the `MessagePiece`s of a request. */
  readonly pieces: MessagePort;
}

/** What is called of the decoding thread. */
export interface DecodeThread {
  /**
   * Resolves when all pieces of the request were sent.
   *
   * @throws {Error} why the body could not be decoded, a sentence without its full stop
   */
  decode(format: FormatName, bytes: Uint8Array<ArrayBuffer>): void;
}
