import { type NatsConnection, headers, type Msg, type Subscription } from '@nats-io/transport-node';
import { within, type Cancel } from '@ubii/timing';
import type { BusListener, ClusterBus } from '../../core/ports/index.ts';
import { reasonOf } from './explain-nats-error.ts';
import { formatPart, parsePart, PartJoiner } from './message-parts.ts';
import type { NatsLink } from './nats-link.ts';

/** Ids of masters are UUIDs; nothing else becomes a part of a subject. */
const UUID = /^[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}$/;

/** Masters whose subjects are kept. */
const MAX_KNOWN = 1_000;

function isMasterId(text: string): boolean {
  return UUID.test(text);
}

/** Subjects of the messages between masters, `ubii.<cluster>.…`. [CU-50] */
class BusSubjects {
  readonly #cluster: string;
  readonly #own: string;
  readonly #to = new Map<string, string>();
  /** Senders by the subject of what they sent. */
  readonly #senders = new Map<string, string>();
  /** What others send to this master. */
  readonly forOwn: string;
  /** What others send to every master. */
  readonly forAll: string;
  readonly toAll: string;

  /** @param masterId of the master that sends */
  constructor(cluster: string, masterId: string) {
    this.#cluster = cluster;
    this.#own = masterId;
    this.forOwn = `ubii.${cluster}.to.${masterId}.*`;
    this.forAll = `ubii.${cluster}.all.*`;
    this.toAll = `ubii.${cluster}.all.${masterId}`;
  }

  /** @returns undefined when that is no id of a master */
  to(receiver: string): string | undefined {
    const known = this.#to.get(receiver);
    if (known !== undefined || !isMasterId(receiver)) return known;
    // Masters come and go with new ids.
    if (this.#to.size >= MAX_KNOWN) this.#to.clear();
    const subject = `ubii.${this.#cluster}.to.${receiver}.${this.#own}`;
    this.#to.set(receiver, subject);
    return subject;
  }

  /** @returns the id of the master that sent to this subject; undefined when no master did */
  senderOf(subject: string): string | undefined {
    const known = this.#senders.get(subject);
    if (known !== undefined) return known;
    const sender = subject.slice(subject.lastIndexOf('.') + 1);
    if (!isMasterId(sender)) return undefined;
    if (this.#senders.size >= MAX_KNOWN) this.#senders.clear();
    this.#senders.set(subject, sender);
    return sender;
  }
}

/** The parts of the library's connection that hold bytes. It has no public way to ask; its version is pinned. */
interface Inside {
  readonly protocol: {
    readonly outbound: { size(): number };
    readonly transport?: { readonly socket?: { readonly writableLength: number } };
  };
}

/** Bytes that were published and that the system has not taken yet. */
function queuedBytesOf(connection: NatsConnection): number {
  const { outbound, transport } = (connection as unknown as Inside).protocol;
  return outbound.size() + (transport?.socket?.writableLength ?? 0);
}

/** Header of a message that is a part of a larger one. [CU-52] */
const PART_HEADER = 'Ubii-Part';
/** The header and what belongs to it take less, bytes. */
const HEADER_BYTES = 128;
/** Time for what was sent to reach NATS when a master ends, milliseconds. */
const CLOSE_MS = 1_000;

/** Messages between masters as messages of NATS. The library writes them at the end of a turn, all in one. [CU-50] */
export class NatsBus implements ClusterBus {
  readonly #link: NatsLink;
  readonly #cluster: string;
  readonly #maxBytes: number;
  readonly #joiner: PartJoiner;
  #joined: Joined | undefined;
  #isReachable = false;
  #lastMessage = 0;

  /** @param maxMessageBytes larger messages are dropped, by sender and receiver */
  constructor(link: NatsLink, cluster: string, maxMessageBytes: number) {
    this.#link = link;
    this.#cluster = cluster;
    this.#maxBytes = maxMessageBytes;
    this.#joiner = new PartJoiner(maxMessageBytes);
  }

  get queuedBytes(): number {
    return queuedBytesOf(this.#link.connection);
  }

  listen(masterId: string, listener: BusListener): void {
    if (!isMasterId(masterId))
      throw new TypeError(`The id of a master must be a UUID: ${masterId}`);
    const subjects = new BusSubjects(this.#cluster, masterId);
    const { connection } = this.#link;
    const subscribe = (subject: string): Subscription =>
      connection.subscribe(subject, { callback: (error, msg) => this.#receive(error, msg) });
    this.#joined = {
      subjects,
      listener,
      subscriptions: [subscribe(subjects.forOwn), subscribe(subjects.forAll)],
      cancel: this.#link.onReach((isConnected) => this.#handleReach(isConnected)),
    };
    if (this.#link.isConnected) this.#handleReach(true);
  }

  send(toMasterId: string, message: Uint8Array): void {
    const subject = this.#joined?.subjects.to(toMasterId);
    if (subject !== undefined) this.#publish(subject, message);
  }

  broadcast(message: Uint8Array): void {
    if (this.#joined !== undefined) this.#publish(this.#joined.subjects.toAll, message);
  }

  async close(): Promise<void> {
    const joined = this.#joined;
    this.#joined = undefined;
    if (joined === undefined) return;
    joined.cancel();
    for (const subscription of joined.subscriptions) subscription.unsubscribe();
    if (!this.#link.isConnected) return;
    const { clock, connection } = this.#link;
    await within(clock, CLOSE_MS, connection.flush()).catch(() => undefined);
  }

  #publish(subject: string, message: Uint8Array): void {
    // The library would keep it for later, without a limit.
    if (!this.#isReachable || !this.#link.isConnected) return;
    const { log } = this.#link;
    if (message.byteLength > this.#maxBytes) {
      log.warn('a message between masters is too large', { sizeBytes: message.byteLength });
      return;
    }
    try {
      if (message.byteLength <= this.#link.maxPayloadBytes) {
        this.#link.connection.publish(subject, message);
      } else {
        this.#publishParts(subject, message);
      }
    } catch (error) {
      log.warn('a message between masters was lost', { reason: reasonOf(error) });
    }
  }

  #publishParts(subject: string, message: Uint8Array): void {
    const partBytes = this.#link.maxPayloadBytes - HEADER_BYTES;
    if (partBytes <= 0) return;
    this.#lastMessage += 1;
    const totalBytes = message.byteLength;
    for (let offset = 0; offset < totalBytes; offset += partBytes) {
      const facts = { message: this.#lastMessage, offset, totalBytes };
      const partHeaders = headers();
      partHeaders.set(PART_HEADER, formatPart(facts));
      const part = message.subarray(offset, offset + partBytes);
      this.#link.connection.publish(subject, part, { headers: partHeaders });
    }
  }

  /** Of the library, which stops reading permanently when this throws. */
  #receive(error: Error | null, msg: Msg): void {
    if (error !== null) {
      this.#link.log.error('messages of other masters cannot be received', {
        reason: reasonOf(error),
      });
      return;
    }
    try {
      this.#take(msg);
    } catch (cause) {
      this.#link.log.error('a message of another master failed', { reason: reasonOf(cause) });
    }
  }

  #take(msg: Msg): void {
    const joined = this.#joined;
    const sender = joined?.subjects.senderOf(msg.subject);
    if (joined === undefined || sender === undefined) return;
    const message = this.#wholeOf(sender, msg);
    if (message !== undefined) joined.listener.handleMessage(sender, message);
  }

  #wholeOf(sender: string, msg: Msg): Uint8Array | undefined {
    const header = msg.headers?.get(PART_HEADER);
    if (header === undefined || header === '') {
      this.#joiner.drop(sender);
      return msg.data;
    }
    const facts = parsePart(header);
    return facts && this.#joiner.add(sender, facts, msg.data);
  }

  #handleReach(isConnected: boolean): void {
    if (!isConnected) {
      this.#setReachable(false);
      return;
    }
    // Once NATS has the subscriptions, nothing is missed that others answer.
    this.#link.connection.flush().then(
      () => this.#setReachable(this.#link.isConnected),
      () => undefined, // Lost meanwhile: this is called again.
    );
  }

  #setReachable(isReachable: boolean): void {
    if (isReachable === this.#isReachable) return;
    this.#isReachable = isReachable;
    this.#joined?.listener.handleReach(isReachable);
  }
}

/** A bus that receives. */
interface Joined {
  readonly subjects: BusSubjects;
  readonly listener: BusListener;
  readonly subscriptions: readonly Subscription[];
  readonly cancel: Cancel;
}
