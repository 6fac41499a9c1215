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
  #hasEnded = false;

  constructor(serverPattern: ServerPattern, listener: EncodedListener) {
    this.serverPattern = serverPattern;
    this.#listener = listener;
  }

  handleRecord(record: ReceivedRecord, isSole: boolean): void {
    if (this.#hasEnded) return;
    const isOwned = isSole && record.isTransferable;
    this.#tell(() => this.#listener.onRecord(isOwned ? record.handOver() : record.encoded));
  }

  handleGone(topic: string): void {
    if (!this.#hasEnded) this.#tell(() => this.#listener.onGone(topic));
  }

  handleAccepted(): void {}

  /** A refusal is told as a problem of the client. */
  end(): void {
    this.#hasEnded = true;
  }

  failIterators(): void {}

  /** A fault of the program, not of the link. */
  #tell(call: () => void): void {
    try {
      call();
    } catch (error) {
      void Promise.reject(error);
    }
  }
}
