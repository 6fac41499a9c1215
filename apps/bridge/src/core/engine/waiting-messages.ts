import { BRIDGE_LIMITS } from '../limits.ts';
import type { OutgoingMessage, Sent } from '../ports/foreign-system.ts';

interface Waiting<P> {
  readonly message: OutgoingMessage<P>;
  readonly sizeBytes: number;
}

/** Messages that wait for the connection: the newest of each address, up to a number and a size. [BR-32] */
export class WaitingMessages<P> {
  readonly #messages = new Map<string, Waiting<P>>();
  readonly #onDropped: (message: OutgoingMessage<P>, reason: string) => void;
  #bytes = 0;

  constructor(onDropped: (message: OutgoingMessage<P>, reason: string) => void) {
    this.#onDropped = onDropped;
  }

  get count(): number {
    return this.#messages.size;
  }

  add(message: OutgoingMessage<P>, sizeBytes: number): Sent {
    this.drop(message.address, 'A newer value took its place.');
    if (sizeBytes > BRIDGE_LIMITS.waitingBytes) {
      return { kind: 'dropped', reason: 'Too large to wait for the connection.' };
    }
    this.#messages.set(message.address, { message, sizeBytes });
    this.#bytes += sizeBytes;
    while (
      this.#messages.size > BRIDGE_LIMITS.waitingMessages ||
      this.#bytes > BRIDGE_LIMITS.waitingBytes
    ) {
      const [oldest] = this.#messages;
      if (oldest === undefined) break;
      this.#drop(oldest[0], oldest[1], 'Too many messages wait for the connection.');
    }
    return { kind: 'waiting' };
  }

  /** The message that waits for an address. */
  get(address: string): OutgoingMessage<P> | undefined {
    return this.#messages.get(address)?.message;
  }

  /** Drops the message that waits for an address, if there is one. */
  drop(address: string, reason: string): void {
    const waiting = this.#messages.get(address);
    if (waiting !== undefined) this.#drop(address, waiting, reason);
  }

  /** Takes all, the one first that waits longest. */
  takeAll(): readonly OutgoingMessage<P>[] {
    const all = [...this.#messages.values()].map(({ message }) => message);
    this.#messages.clear();
    this.#bytes = 0;
    return all;
  }

  #drop(address: string, { message, sizeBytes }: Waiting<P>, reason: string): void {
    this.#messages.delete(address);
    this.#bytes -= sizeBytes;
    this.#onDropped(message, reason);
  }
}
