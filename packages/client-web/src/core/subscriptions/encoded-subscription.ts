import { reportRejection } from '../callbacks/program-errors.ts';
import type { ErrorHandler } from '../ports/error-handler.ts';
import type { EncodedListener } from './encoded-record.ts';
import type { ReceivedRecord } from './received-record.ts';
import type { Receiver } from './receiver.ts';
import type { ServerPattern } from './topic-pattern.ts';

/** A subscription that takes records as they travel. */
export class EncodedSubscription implements Receiver {
  readonly serverPattern: ServerPattern;
  readonly maxRateHz = Infinity;
  readonly takesBuffers = true;
  readonly #listener: EncodedListener;
  readonly #onError: ErrorHandler;
  #hasEnded = false;

  constructor(serverPattern: ServerPattern, listener: EncodedListener, onError: ErrorHandler) {
    this.serverPattern = serverPattern;
    this.#listener = listener;
    this.#onError = onError;
  }

  handleRecord(record: ReceivedRecord, isSole: boolean): void {
    if (this.#hasEnded) return;
    const isOwned = isSole && record.isTransferable;
    const encoded = isOwned ? record.handOver() : record.encoded;
    try {
      reportRejection(this.#listener.onRecord(encoded), 'listener', this.#onError);
    } catch (error) {
      this.#onError(error, 'listener');
    }
  }

  handleGone(topic: string): void {
    if (this.#hasEnded) return;
    try {
      reportRejection(this.#listener.onGone(topic), 'listener', this.#onError);
    } catch (error) {
      this.#onError(error, 'listener');
    }
  }

  handleAccepted(): void {}

  /** A refusal is reported as a problem of the client. */
  end(): void {
    this.#hasEnded = true;
  }

  failIterators(): void {}
}
