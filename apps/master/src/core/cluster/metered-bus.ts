import type { BusListener, ClusterBus } from '../ports/cluster-bus.ts';

/** Bytes that crossed between this master and another one. */
export interface CrossedBytes {
  to: number;
  from: number;
}

/** A bus whose bytes are counted, in total and for each master that is followed. [CU-73] */
export class MeteredBus implements ClusterBus {
  readonly #bus: ClusterBus;
  readonly #followed = new Map<string, CrossedBytes>();
  /** Of all masters together; what goes to all counts once. */
  readonly total: CrossedBytes = { to: 0, from: 0 };

  constructor(bus: ClusterBus) {
    this.#bus = bus;
  }

  get queuedBytes(): number {
    return this.#bus.queuedBytes;
  }

  /** Counts the bytes of one master from now on. */
  follow(masterId: string): CrossedBytes {
    const bytes = { to: 0, from: 0 };
    this.#followed.set(masterId, bytes);
    return bytes;
  }

  unfollow(masterId: string): void {
    this.#followed.delete(masterId);
  }

  listen(masterId: string, listener: BusListener): void {
    this.#bus.listen(masterId, {
      handleMessage: (from, message) => {
        this.total.from += message.byteLength;
        const bytes = this.#followed.get(from);
        if (bytes !== undefined) bytes.from += message.byteLength;
        listener.handleMessage(from, message);
      },
      handleReach: (isReachable) => listener.handleReach(isReachable),
    });
  }

  send(toMasterId: string, message: Uint8Array): void {
    this.total.to += message.byteLength;
    const bytes = this.#followed.get(toMasterId);
    if (bytes !== undefined) bytes.to += message.byteLength;
    this.#bus.send(toMasterId, message);
  }

  broadcast(message: Uint8Array): void {
    this.total.to += message.byteLength;
    for (const bytes of this.#followed.values()) bytes.to += message.byteLength;
    this.#bus.broadcast(message);
  }

  close(): Promise<void> {
    return this.#bus.close();
  }
}
