import type {
  ClusterClient,
  ClusterInterest,
  ClusterMaster,
  ClusterPart,
  ClusterRecords,
  ClusterSessionNews,
  Init,
} from '@ubii/proto';
import type { RecordPart } from '@ubii/proto/wire';
import type { EndOfTurn } from '@ubii/timing';
import type { Client } from '../clients/client.ts';
import { RESOURCE } from '../shares/resources.ts';
import type { TopicTable } from '../topics/topic-table.ts';
import type { Directory } from './directory.ts';
import { describeClient } from './directory.ts';
import { interestKey } from './interest-key.ts';
import type { LocalInterest } from './local-interest.ts';
import { PeerSubscriber, type PeerSubscriberContext } from './peer-subscriber.ts';
import type { CrossedBytes } from './metered-bus.ts';
import { PeerRates, type PeerTotals } from './peer-rates.ts';
import { PeerRoundTrip } from './peer-round-trip.ts';
import { Resync } from './resync.ts';
import type { SessionMirror } from './session-mirror.ts';
import { IncomingStream, OutgoingStream } from './streams.ts';
import type { ReceivedRecords } from './received-records.ts';

/** Bytes of clients in one message, unless a single one has more. */
const CLIENTS_BYTES = 256 * 1024;
/** Bytes of a client besides what it registered. */
const CLIENT_BYTES = 512;
/** Looks in which parts of an earlier stream may still come. */
const OLD_PARTS_LOOKS = 20;
/** The longest wait before a stream is asked for that was asked for without effect, looks. */
const MAX_WAIT_LOOKS = 60;
/** Looks at a stream without a part, after which it is asked for again. */
const SILENT_LOOKS = 5;
/** Subscriptions in one message. */
const INTERESTS_PER_PART = 500;

/** Dependencies of a peer. */
export interface PeerContext extends PeerSubscriberContext {
  readonly topics: TopicTable;
  readonly endOfTurn: EndOfTurn;
  readonly directory: Directory;
  readonly interest: LocalInterest;
  readonly received: ReceivedRecords;
  readonly mirror: SessionMirror;
  /** Of all messages to and from the other master. */
  readonly bytes: CrossedBytes;
  /** Bytes for a client of this master, and from a node of the other one. [CU-24] */
  readonly onFrame: (clientId: string, frame: Uint8Array) => void;
  readonly onNodeMessage: (clientId: string, message: Uint8Array) => void;
}

/** Another master: the messages to it and from it. */
export class Peer {
  readonly id: string;
  readonly #context: PeerContext;
  readonly #outgoing: OutgoingStream;
  readonly #incoming: IncomingStream;
  readonly #subscriber: PeerSubscriber;
  readonly #interests = new Map<string, ClusterInterest>();
  #resync: Resync | undefined = undefined;
  #silentLooks = 0;
  #looksSinceListen = 0;
  /** Consecutive streams that ended before they were complete. */
  #failures = 0;
  #waitLooks = 0;
  #shouldListen = false;
  readonly #roundTrip = new PeerRoundTrip();
  readonly #rates: PeerRates;
  #recordsFrom = 0;
  /** A message of it has come since it appeared. */
  #hasReceived = false;
  /** Gaps in its messages so far. */
  gaps = 0;

  constructor(parts: PeerContext, id: string) {
    this.id = id;
    this.#context = parts;
    this.#outgoing = new OutgoingStream(parts.bus, id);
    this.#incoming = new IncomingStream(parts.bus, id);
    this.#subscriber = new PeerSubscriber(parts, id, this.#outgoing);
    this.#rates = new PeerRates(this.#totals(), parts.clock.monotonicMs());
  }

  /** Records that it did not get, because they could not be sent as fast as they were published. */
  get dropped(): number {
    return this.#subscriber.dropped;
  }

  /** All that it has was received. */
  get isComplete(): boolean {
    return this.#resync?.isComplete !== false && !this.#shouldListen;
  }

  /** Traffic between it and this master. [CU-73] [CU-74] */
  describe(): Init<ClusterMaster> {
    const { recordsTo, recordsFrom } = this.#totals();
    return {
      roundTripMs: this.#roundTrip.latestMs,
      recordsTo,
      recordsFrom,
      ...this.#rates.latest,
      queuedRecords: this.#subscriber.queuedRecords,
      dropped: this.dropped,
      gaps: this.gaps,
      complete: this.isComplete,
    };
  }

  /** Asks it for all it has. */
  listen(): void {
    this.#resync = new Resync(this.#context, this.id);
    this.#silentLooks = 0;
    this.#looksSinceListen = 0;
    this.#incoming.listen();
  }

  /** It asks for all that this master has. [CU-5] */
  handleListen(stream: number): void {
    this.#outgoing.restart(stream);
    this.sendClients(this.#context.directory.own(), []);
    for (const news of this.#context.mirror.own()) this.#outgoing.send({ sessionNews: [news] });
    for (const wanted of chunks(this.#context.interest.list(), INTERESTS_PER_PART)) {
      this.#outgoing.send({ wanted });
    }
    this.#subscriber.replayAll();
    this.#subscriber.handleEndOfTurn();
    this.#outgoing.send({ complete: true });
  }

  /** Handles a message of the other master. @throws DecodeError when a record cannot be read */
  handlePart(part: ClusterPart): void {
    if (!this.#isNext(part)) return;
    this.#roundTrip.handleTimes(part, this.#context.clock.monotonicMs());
    this.#apply(part);
  }

  /** Handles a message with records alone: the hot path between masters. @throws DecodeError as above */
  handleRecords(part: RecordPart): void {
    if (this.#isNext(part)) this.#publish(part.records);
  }

  sendClients(clients: readonly Client[], goneClients: readonly string[]): void {
    if (goneClients.length > 0) this.#outgoing.send({ goneClients: [...goneClients] });
    let batch: Init<ClusterClient>[] = [];
    let byteLength = 0;
    for (const client of clients) {
      const size = CLIENT_BYTES + client.account.used(RESOURCE.registrationBytes);
      if (batch.length > 0 && byteLength + size > CLIENTS_BYTES) {
        this.#outgoing.send({ clients: batch });
        batch = [];
        byteLength = 0;
      }
      batch.push(describeClient(client));
      byteLength += size;
    }
    if (batch.length > 0) this.#outgoing.send({ clients: batch });
  }

  sendSession(news: Init<ClusterSessionNews>): void {
    this.#outgoing.send({ sessionNews: [news] });
  }

  /** Has bytes sent to one of its clients. */
  sendFrame(clientId: string, frame: Uint8Array): void {
    this.#outgoing.send({ frames: [{ clientId, bytes: frame }] });
  }

  /** A node of this master, of whom it runs modules, says something. */
  sendNodeMessage(clientId: string, message: Uint8Array): void {
    this.#outgoing.send({ nodeMessages: [{ clientId, bytes: message }] });
  }

  sendInterest(
    wanted: readonly Init<ClusterInterest>[],
    unwanted: readonly Init<ClusterInterest>[],
  ): void {
    this.#outgoing.send({ wanted: [...wanted], unwanted: [...unwanted] });
  }

  /** To be called about twice a second: says that this master is there, and notices when the other is not. [CU-6] */
  sweep(): void {
    const nowMs = this.#context.clock.monotonicMs();
    this.#outgoing.send(this.#roundTrip.times(nowMs));
    this.#rates.measure(this.#totals(), nowMs);
    this.#subscriber.sweep();
    this.#looksSinceListen++;
    this.#resync?.sweep();
    if (this.#waitLooks > 0) this.#waitLooks--;
    if (++this.#silentLooks >= SILENT_LOOKS) this.#listenAgain();
    else if (this.#shouldListen && this.#waitLooks === 0) this.#listenNow();
  }

  close(): void {
    this.#subscriber.close();
  }

  #apply(part: ClusterPart): void {
    const { directory, received } = this.#context;
    const resync = this.#resync;
    for (const id of part.goneClients) directory.delete(this.id, id);
    for (const client of part.clients) {
      directory.set(this.id, client);
      resync?.note('clients', client.client?.id ?? '');
    }
    for (const news of part.sessionNews) {
      this.#context.mirror.handleNews(this.id, news);
      resync?.note('sessions', news.session?.id ?? '');
    }
    for (const { clientId, bytes } of part.frames) this.#context.onFrame(clientId, bytes);
    for (const { clientId, bytes } of part.nodeMessages) {
      this.#context.onNodeMessage(clientId, bytes);
    }
    for (const interest of part.wanted) this.#want(interest);
    for (const interest of part.unwanted) this.#endWant(interestKey(interest));
    if (part.values !== undefined) received.publish(this.id, part.values, true, resync?.topics);
    if (part.records !== undefined) this.#publish(part.records);
    if (part.complete && resync?.isComplete === false) this.#complete(resync);
  }

  #publish(records: ClusterRecords): void {
    this.#recordsFrom += records.records.length;
    this.#context.received.publish(this.id, records, false, this.#resync?.topics);
  }

  /** Counts a part. @returns whether it is to be read */
  #isNext(part: Pick<ClusterPart, 'stream' | 'number'>): boolean {
    const place = this.#incoming.place(part);
    if (place === 'gap') this.#listenAgain();
    else if (place === 'next' || this.#looksSinceListen < OLD_PARTS_LOOKS) this.#silentLooks = 0;
    if (place === 'next') this.#hasReceived = true;
    return place === 'next';
  }

  #totals(): PeerTotals {
    const { to: bytesTo, from: bytesFrom } = this.#context.bytes;
    const { sentRecords: recordsTo } = this.#subscriber;
    return { recordsTo, recordsFrom: this.#recordsFrom, bytesTo, bytesFrom };
  }

  /** Asks for the stream again after a gap, not more often than the limit. [CU-7] */
  #listenAgain(): void {
    if (this.#shouldListen) return;
    // A first request that gets lost while both start costs nothing that was known.
    if (this.#hasReceived) this.gaps++;
    this.#shouldListen = true;
    if (this.#waitLooks === 0) this.#listenNow();
  }

  #listenNow(): void {
    this.#shouldListen = false;
    this.#waitLooks = Math.min(MAX_WAIT_LOOKS, 2 ** this.#failures - 1);
    this.#failures = Math.min(this.#failures + 1, 10);
    this.listen();
  }

  #want(interest: ClusterInterest): void {
    const key = interestKey(interest);
    this.#resync?.note('interests', key);
    this.#interests.set(key, interest);
    this.#subscriber.want(interest);
  }

  #endWant(key: string): void {
    const interest = this.#interests.get(key);
    if (interest === undefined) return;
    this.#interests.delete(key);
    this.#subscriber.endWant(interest);
  }

  #complete(resync: Resync): void {
    this.#failures = 0;
    resync.complete({
      keys: [...this.#interests.keys()],
      end: (key) => this.#endWant(key),
    });
  }
}

function* chunks<T>(all: readonly T[], size: number): Iterable<T[]> {
  for (let start = 0; start < all.length; start += size) yield all.slice(start, start + size);
}
