import type { Clock } from '@ubii/timing';
import { forgetFirst } from '../forget-first.ts';
import type { Mapping } from '../mapping/mapping.ts';
import type {
  ForeignMessage,
  ForeignSystem,
  OutgoingMessage,
  Sent,
} from '../ports/foreign-system.ts';
import { WaitingMessages } from './waiting-messages.ts';

/** Addresses that are remembered, of all mappings together. */
const REMEMBERED_ADDRESSES = 10_000;
/** By then the master has sent the values that stand, milliseconds. */
const REPLAY_MS = 10_000;

/** Dependencies of a `SendGate`. */
export interface GateContext<P> {
  readonly clock: Clock;
  readonly foreign: Pick<ForeignSystem<P>, 'send'>;
  /** A message left, or waits in the adapter. */
  onSent(address: string, payload: P): void;
  onDropped(mapping: Mapping, reason: string): void;
}

/**
 * What leaves for the other system, and which value counts where both sides have one. Messages of mappings in both directions with
 * `retained` wait until the system has given what it keeps: that takes their place. Later, it is the older one. [BR-14]
 */
export class SendGate<P> {
  readonly #context: GateContext<P>;
  readonly #waiting: WaitingMessages<P>;
  #isOpen = false;
  /** Addresses whose value left since the gate was opened. */
  readonly #left = new Set<string>();
  /** Content of the newest message that was taken of each address, until a value leaves for it. */
  readonly #taken = new Map<string, string>();
  /** When a kept message was taken of each address, and whether the master has it, until the next record of others. */
  readonly #keptTaken = new Map<string, { readonly atMs: number; isPublished: boolean }>();

  constructor(context: GateContext<P>) {
    this.#context = context;
    this.#waiting = new WaitingMessages(({ mapping }, reason) =>
      context.onDropped(mapping, reason),
    );
  }

  /** @param sizeBytes what the message takes while it waits */
  send(message: OutgoingMessage<P>, sizeBytes: number): Sent {
    if (!hasTwoValues(message.mapping)) return this.#send(message);
    if (!this.#isOpen) return this.#waiting.add(message, sizeBytes);
    return this.#sendKept(message);
  }

  /** Messages wait from now on. @param isNew the connection is another one, so that what left before may be lost */
  close(isNew: boolean): void {
    this.#isOpen = false;
    if (isNew) this.#left.clear();
  }

  /** The other system has given what it keeps. */
  open(): void {
    if (this.#isOpen) return;
    this.#isOpen = true;
    for (const message of this.#waiting.takeAll()) {
      const sent = this.#sendKept(message);
      if ('reason' in sent) this.#context.onDropped(message.mapping, sent.reason);
    }
  }

  /** Whether a message that the other system kept counts more than what the master has. @param content hash of it */
  isNews(message: ForeignMessage<P>, timestampMs: number | undefined, content: string): boolean {
    const { address } = message;
    if (this.#left.has(address) || this.#taken.get(address) === content) return false;
    const waitingMs = this.#waiting.get(address)?.timestampMs;
    return timestampMs === undefined || waitingMs === undefined || waitingMs <= timestampMs;
  }

  /** A message of the other system was taken: what waits for its address is older. @param content hash of it */
  handleTaken({ address, isKept }: ForeignMessage<P>, content: string): void {
    this.#waiting.drop(address, 'The other side has a newer value.');
    this.#taken.delete(address);
    this.#taken.set(address, content);
    forgetFirst(this.#taken, REMEMBERED_ADDRESSES);
    if (!isKept) return;
    this.#keptTaken.set(address, { atMs: this.#context.clock.nowMs(), isPublished: false });
    forgetFirst(this.#keptTaken, REMEMBERED_ADDRESSES);
  }

  /** The master has sent the bridge's own record for an address: what comes after it was published later. */
  handlePublished(address: string): void {
    const taken = this.#keptTaken.get(address);
    if (taken !== undefined) taken.isPublished = true;
  }

  /** Whether a record is the value that the master had before a kept message was taken, which may arrive after it. */
  isOlder({ address, mapping, timestampMs }: OutgoingMessage<P>): boolean {
    const taken = this.#keptTaken.get(address);
    if (taken === undefined || !hasTwoValues(mapping)) return false;
    this.#keptTaken.delete(address);
    if (this.#context.clock.nowMs() - taken.atMs > REPLAY_MS) return false;
    return timestampMs === undefined ? !taken.isPublished : timestampMs < taken.atMs;
  }

  #sendKept(message: OutgoingMessage<P>): Sent {
    const { address } = message;
    this.#taken.delete(address);
    this.#left.add(address);
    forgetFirst(this.#left, REMEMBERED_ADDRESSES);
    return this.#send(message);
  }

  #send(message: OutgoingMessage<P>): Sent {
    const sent = this.#context.foreign.send(message);
    const { address, payload } = message;
    const isOnItsWay = sent.kind === 'sent' || sent.kind === 'waiting';
    if (isOnItsWay && payload !== undefined) this.#context.onSent(address, payload);
    return sent;
  }
}

/** Whether both sides of a mapping keep values, and take them from each other. */
export function hasTwoValues({ direction, retained }: Mapping): boolean {
  return direction === 'both' && retained;
}
