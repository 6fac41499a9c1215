import type { MessagePort } from 'node:worker_threads';

import type { FormatName } from '../service-format.ts';

/** Initial data of the decoding thread. */
export interface DecodeWorkerData {
  /** Receives the `MessagePiece`s of a request. */
  readonly pieces: MessagePort;
}

/** A body to decode. */
export interface DecodeJob {
  readonly format: FormatName;
  readonly bytes: Uint8Array<ArrayBuffer>;
}

/** Follows the pieces of a request. */
export interface DecodeAnswer {
  /** Why the body could not be decoded, a sentence without its full stop; undefined: it was. */
  readonly reason?: string;
}
