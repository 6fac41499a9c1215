import type { Peer } from './peer.ts';

/** The other masters that are there, by id, with counters of all that were there. */
export class Peers {
  readonly #peers = new Map<string, Peer>();
  #gapsBefore = 0;
  #droppedBefore = 0;

  get(masterId: string): Peer | undefined {
    return this.#peers.get(masterId);
  }

  ids(): string[] {
    return [...this.#peers.keys()];
  }

  [Symbol.iterator](): Iterator<Peer> {
    return this.#peers.values();
  }

  add(peer: Peer): void {
    this.#peers.set(peer.id, peer);
  }

  /** Closes and removes a master. */
  end(masterId: string): void {
    const peer = this.#peers.get(masterId);
    if (peer === undefined) return;
    this.#gapsBefore += peer.gaps;
    this.#droppedBefore += peer.dropped;
    peer.close();
    this.#peers.delete(masterId);
  }

  close(): void {
    for (const id of this.ids()) this.end(id);
  }

  /** Times that something was missing of what other masters sent. */
  get gaps(): number {
    return this.#sumOf((peer) => peer.gaps, this.#gapsBefore);
  }

  /** Records that other masters did not get, because they could not be sent as fast as they were published. */
  get dropped(): number {
    return this.#sumOf((peer) => peer.dropped, this.#droppedBefore);
  }

  /** Masters of which all that they have was received. */
  get completeCount(): number {
    return this.#sumOf((peer) => (peer.isComplete ? 1 : 0), 0);
  }

  #sumOf(read: (peer: Peer) => number, before: number): number {
    let sum = before;
    for (const peer of this.#peers.values()) sum += read(peer);
    return sum;
  }
}
