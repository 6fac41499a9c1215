import type { ClusterPart, Init } from '@ubii/proto';
import { encodeRecordPart, type RecordsForMasters } from '@ubii/proto/wire';
import type { ProvenBus } from './proven-bus.ts';

/** Content of one message of a stream. */
export type PartContent = Omit<Init<ClusterPart>, 'stream' | 'number'>;

/** Messages from this master to another one, in numbered parts. [CU-6] */
export class OutgoingStream {
  readonly #bus: ProvenBus;
  readonly #peerId: string;
  #stream = 0;
  #next = 0;

  constructor(bus: ProvenBus, peerId: string) {
    this.#bus = bus;
    this.#peerId = peerId;
  }

  /** Whether the other master listens. */
  get isOpen(): boolean {
    return this.#stream !== 0;
  }

  /** Begins again, with the number that the listener chose. */
  restart(stream: number): void {
    this.#stream = stream;
    this.#next = 0;
  }

  send(content: PartContent): void {
    if (!this.isOpen) return;
    const part = { ...content, stream: this.#stream, number: this.#next++ };
    this.#bus.send(this.#peerId, { part });
  }

  /** Sends records that were just published. The hot path between masters. */
  sendRecords(records: RecordsForMasters): void {
    if (!this.isOpen) return;
    this.#bus.sendRecords(this.#peerId, encodeRecordPart(this.#stream, this.#next++, records));
  }
}

/** Place of a part in a stream, as the listener finds it. */
export type PartPlace = 'next' | 'old' | 'gap';

/** Messages from another master to this one. */
export class IncomingStream {
  readonly #bus: ProvenBus;
  readonly #peerId: string;
  #stream = 0;
  #next = 0;

  constructor(bus: ProvenBus, peerId: string) {
    this.#bus = bus;
    this.#peerId = peerId;
  }

  /** Asks for all from the start. */
  listen(): void {
    this.#stream++;
    this.#next = 0;
    this.#bus.send(this.#peerId, { listen: { stream: this.#stream } });
  }

  /** Counts a part. @returns whether it is the next one, of an earlier stream, or others are missing before it */
  place({ stream, number }: Pick<ClusterPart, 'stream' | 'number'>): PartPlace {
    if (stream !== this.#stream || number < this.#next) return 'old';
    if (number > this.#next) return 'gap';
    this.#next++;
    return 'next';
  }
}
