import {
  DecodeError,
  MASTERS_TOPIC,
  StatusEventKind,
  type ClusterCall,
  type Init,
  type ServiceReply,
  type ServiceRequest,
  type TopicStatistics,
} from '@ubii/proto';
import { readRecordPart, TextCache } from '@ubii/proto/wire';
import type { Cancel } from '@ubii/timing';
import type { Client } from '../clients/client.ts';
import type { CallerFacts } from '../ports/caller-facts.ts';
import type { BusListener } from '../ports/cluster-bus.ts';
import { quote } from '../texts/quote.ts';
import { Calls } from './calls.ts';
import { ClientNews } from './client-news.ts';
import type { ClusterContext } from './cluster-context.ts';
import { Directory } from './directory.ts';
import { ForeignTopics } from './foreign-topics.ts';
import { ForeignValues } from './foreign-values.ts';
import { ClusterAddresses } from './cluster-addresses.ts';
import { LostMasters } from './lost-masters.ts';
import { HELLO_MS, Members, type Member } from './members.ts';
import { MeteredBus } from './metered-bus.ts';
import { LocalInterest } from './local-interest.ts';
import { Peer } from './peer.ts';
import { Peers } from './peers.ts';
import { ProvenBus } from './proven-bus.ts';
import { SessionMirror } from './session-mirror.ts';
import { Takeover } from './takeover.ts';
import { ReceivedRecords } from './received-records.ts';

/** Time that other masters have to add to a reply, milliseconds. */
const GATHER_MS = 1_000;

/** This master among the masters of its cluster: clients and topics of all of them are one world. [CU-1] */
export class Cluster implements BusListener {
  readonly name: string;
  readonly members: Members;
  readonly lost = new LostMasters();
  readonly clusterAddresses = new ClusterAddresses();
  readonly #context: Omit<ClusterContext, 'bus'> & { readonly bus: ProvenBus };
  readonly #bus: MeteredBus;
  readonly #texts = new TextCache();
  readonly #clientNews: ClientNews;
  readonly #directory: Directory;
  readonly #interest: LocalInterest;
  readonly #received: ReceivedRecords;
  readonly #mirror: SessionMirror;
  readonly #calls: Calls;
  readonly #topics: ForeignTopics;
  readonly #takeover: Takeover;
  readonly peers = new Peers();
  readonly #values: ForeignValues;
  readonly #cancelSweep: Cancel;
  #isClosed = false;
  /** Whether the bus can be reached. */
  isReachable = false;
  /** Since when it can or cannot be, epoch milliseconds; undefined before it could be. */
  reachSinceMs: number | undefined = undefined;

  constructor(init: ClusterContext) {
    this.#bus = new MeteredBus(init.bus);
    const bus = new ProvenBus({ ...init, bus: this.#bus });
    const context = { ...init, bus };
    this.#context = context;
    this.name = context.name;
    const { clock, clients, self } = context;
    this.members = new Members({ clock, bus, self });
    this.#directory = new Directory(context);
    this.#interest = new LocalInterest(context);
    this.#received = new ReceivedRecords(context);
    this.#mirror = new SessionMirror({
      ...context,
      isReachable: (id) => this.members.get(id) !== undefined,
    });
    this.#calls = new Calls(context);
    this.#topics = new ForeignTopics({
      ...context,
      masterIds: () => this.peers.ids(),
      call: (id, request, facts) =>
        this.#calls.call(id, request, facts, GATHER_MS).catch(() => undefined),
    });
    this.#values = new ForeignValues(context);
    this.#takeover = new Takeover(context, this.members);
    this.#clientNews = new ClientNews({
      clock,
      clients,
      send: (changed, gone) => {
        for (const peer of this.peers) peer.sendClients(changed, gone);
      },
    });
    context.onSessionNews.add((topic, session) => {
      for (const peer of this.peers) peer.sendSession({ topic, session });
    });
    this.#interest.onChange.add((wanted, unwanted) => {
      for (const peer of this.peers) peer.sendInterest(wanted, unwanted);
      if (unwanted.length > 0) this.#values.endUnwanted();
    });
    this.members.onJoined.add(({ addresses }) => {
      this.clusterAddresses.add(addresses);
      this.#publishAddresses();
    });
    this.members.onLost.add((member, hasEnded) => {
      this.#handleLost(member, hasEnded);
      this.#publishAddresses();
    });
    context.info.onClient.add(({ id }) => this.#clientNews.note(id));
    context.info.onClientGone.add(({ id }) => this.#clientNews.note(id));
    context.reports.onBytes.add((node, message) => this.#handleNodeMessage(node, message));
    clients.onForeignFrame.add(({ id, home }, frame) => {
      if (home !== undefined) this.peers.get(home.masterId)?.sendFrame(id, frame);
    });
    this.#cancelSweep = clock.every(HELLO_MS, () => this.#sweep());
    this.#bus.listen(context.id, this);
  }

  /** Bytes of all messages to and from other masters; what goes to all counts once. */
  get bytes(): Readonly<{ to: number; from: number }> {
    return this.#bus.total;
  }

  /** Bytes that the bus has not taken yet. */
  get queuedBytes(): number {
    return this.#bus.queuedBytes;
  }

  /** Whether the id is that of another master, which may be lost. */
  isMaster(id: string): boolean {
    return this.members.get(id) !== undefined || this.lost.has(id);
  }

  /** Of other masters that clients can go to, of each the best first. [CU-26] */
  addresses(): string[] {
    return this.members.listForClients().flatMap(({ addresses }) => addresses);
  }

  handleReach(isReachable: boolean): void {
    this.isReachable = isReachable;
    this.reachSinceMs = this.#context.clock.nowMs();
    if (this.#isClosed) return;
    const text = isReachable ? 'joined the cluster' : 'lost the cluster: NATS cannot be reached';
    this.#context.log[isReachable ? 'info' : 'warn'](text);
    this.#takeover.handleReach(isReachable);
    if (isReachable) this.members.sayHello();
  }

  handleMessage(from: string, bytes: Uint8Array): void {
    if (this.#isClosed || from === this.#context.id) return;
    try {
      const records = readRecordPart(bytes, this.#texts);
      if (records === undefined) this.#handle(from, bytes);
      else this.#handleSign(from)?.handleRecords(records);
    } catch (error) {
      if (!(error instanceof DecodeError)) throw error;
      this.#context.counters.protocolErrors++;
      this.#context.log.warn('a message of another master cannot be read', {
        master: from,
        reason: error.message,
      });
    }
  }

  close(): void {
    this.#isClosed = true;
    this.members.sayGoodbye();
    this.#cancelSweep();
    this.#clientNews.close();
    this.#calls.close();
    this.peers.close();
  }

  /** Has a service request answered by another master. @throws ServiceError when it does not answer */
  call(masterId: string, request: ServiceRequest, facts: CallerFacts): Promise<ServiceReply> {
    return this.#calls.call(masterId, request, facts);
  }

  /** Counters of the topics of all masters that changed since a cursor. [CU-29] */
  topicStatistics(cursor: number, facts: CallerFacts): Promise<Init<TopicStatistics>> {
    return this.#topics.read(cursor, facts);
  }

  /**
   * Asks every other master the same. [CU-29]
   *
   * @returns the replies of those that answered within a second
   */
  async callAll(request: ServiceRequest, facts: CallerFacts): Promise<ServiceReply[]> {
    const asked = this.peers
      .ids()
      .map((id) => this.#calls.call(id, request, facts, GATHER_MS).catch(() => undefined));
    const replies = await Promise.all(asked);
    return replies.filter(
      (reply) => reply !== undefined && reply.error === undefined,
    ) as ServiceReply[];
  }

  /** Forwards a message of a node at this master to the masters that run modules there. [CU-24] */
  #handleNodeMessage({ id: nodeId, home }: Client, message: Uint8Array): void {
    if (home !== undefined) return;
    for (const masterId of this.#context.foreignSessions.mastersUsing(nodeId)) {
      this.peers.get(masterId)?.sendNodeMessage(nodeId, message);
    }
  }

  /** @throws DecodeError when it cannot be read */
  #handle(from: string, bytes: Uint8Array): void {
    const message = this.#context.bus.read(from, bytes);
    if (message === undefined) {
      this.#context.counters.protocolErrors++;
      return;
    }
    const { hello, goodbye, listen, part, call, reply } = message;
    if (goodbye !== undefined) return this.members.handleGoodbye(from);
    if (hello !== undefined) this.members.handleHello(from, hello);
    const peer = this.#handleSign(from);
    if (peer === undefined) {
      // Its hello has not come yet; it is sent every second.
      if (listen !== undefined) this.members.sayHello();
      return;
    }
    if (listen !== undefined) peer.handleListen(listen.stream);
    if (part !== undefined) peer.handlePart(part);
    if (reply !== undefined) this.#calls.handleReply(from, reply);
    if (call !== undefined) this.#handleCall(from, call);
  }

  #handleCall(from: string, call: ClusterCall): void {
    const member = this.members.get(from);
    if (member === undefined) return;
    this.#calls.handleCall(member, call);
  }

  /** @returns undefined for a master that has not identified itself */
  #handleSign(from: string): Peer | undefined {
    if (!this.members.handleSign(from)) return undefined;
    return this.peers.get(from) ?? this.#join(from);
  }

  #join(id: string): Peer {
    const parts = {
      directory: this.#directory,
      interest: this.#interest,
      received: this.#received,
      mirror: this.#mirror,
      bytes: this.#bus.follow(id),
      onFrame: (clientId: string, frame: Uint8Array) =>
        this.#context.clients.get(clientId)?.socket?.sendFrame(frame),
      onNodeMessage: (nodeId: string, message: Uint8Array) => {
        const node = this.#context.clients.get(nodeId);
        if (node !== undefined) this.#context.reports.handleMessage(node, message);
      },
    };
    const peer = new Peer({ ...this.#context, ...parts }, id);
    this.peers.add(peer);
    const text = `The master ${quote(this.members.get(id)?.name ?? id)} is there`;
    this.#context.events.add(StatusEventKind.MASTER_JOINED, text);
    this.#values.handleJoined(id);
    this.lost.delete(id);
    // It may not know this master yet.
    this.members.sayHello();
    peer.listen();
    return peer;
  }

  #handleLost(member: Member, hasEnded: boolean): void {
    const { id, name } = member;
    const text = `The master ${quote(name)} ${hasEnded ? 'ended' : 'is lost'}`;
    this.#context.events.add(StatusEventKind.MASTER_LOST, text);
    this.lost.add({ member, hasEnded, sinceMs: this.#context.clock.nowMs() });
    this.peers.end(id);
    this.#bus.unfollow(id);
    this.#directory.handleLost(id);
    this.#calls.handleLost(id);
    this.#takeover.handleLost(id);
    this.#values.handleLost(id);
  }

  #sweep(): void {
    this.members.sayHello();
    this.members.sweep();
    for (const peer of this.peers) peer.sweep();
    this.#takeover.look();
    this.#values.sweep();
  }

  #publishAddresses(): void {
    const stringList = { elements: this.addresses() };
    this.#context.publisher.publishChange(MASTERS_TOPIC, { stringList });
  }
}
