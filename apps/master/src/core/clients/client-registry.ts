import {
  encode,
  ServiceError,
  StatusEventKind,
  type Client as ClientMessage,
  type Mark,
} from '@ubii/proto';
import type { PatternCompiler } from '@ubii/patterns';
import type { Clock } from '@ubii/timing';
import { TRUSTED_ACCESS, type ClientAccess } from '../access/caller.ts';
import { PublishLimitTable } from '../access/publish-limit-table.ts';
import { shareOf } from '../access/share-of.ts';
import { topicRightsOf } from '../access/topic-rights.ts';
import { areEqual } from '../topics/equal-bytes.ts';
import type { DeviceRegistry } from '../devices/device-registry.ts';
import { Hook } from '../hooks/hook.ts';
import type { InfoTopics } from '../info/info-topics.ts';
import type { IdSource } from '../ports/id-source.ts';
import type { ResumeTokens } from '../ports/resume-tokens.ts';
import type { Accounts } from '../shares/accounts.ts';
import { RESOURCE } from '../shares/resources.ts';
import type { Shortage } from '../shares/shortage.ts';
import type { EventLog } from '../counters/event-log.ts';
import type { LimitWatch } from '../counters/limit-watch.ts';
import type { KeptValues } from '../topics/kept-values.ts';
import type { SubscriptionTable } from '../topics/subscription-table.ts';
import type { SubscriberFactory } from '../topics/subscriber-factory.ts';
import { quote } from '../texts/quote.ts';
import type { TopicTable } from '../topics/topic-table.ts';
import { Client, specOf, type ClientHome, type ClientSpec } from './client.ts';
import type { Dismissal, Dismissals } from './dismissals.ts';
import { leastMissed } from './least-missed.ts';
import { isMark, Marks } from './marks.ts';
import { nextStatus, type ClientEvent, type ClientStatus } from './client-states.ts';

/** Dependencies of a client registry. */
export interface ClientContext {
  readonly clock: Clock;
  readonly ids: IdSource;
  readonly tokens: ResumeTokens;
  readonly limits: LimitWatch;
  readonly events: EventLog;
  readonly topics: TopicTable;
  readonly kept: KeptValues;
  readonly subscriptions: SubscriptionTable;
  readonly devices: DeviceRegistry;
  readonly info: InfoTopics;
  readonly accounts: Accounts;
  readonly createSubscriber: SubscriberFactory;
  readonly patterns: PatternCompiler;
  readonly dismissals: Dismissals;
}

/** What is fixed of a client of another master. */
export interface ForeignClientInit {
  readonly home: ClientHome;
  readonly spec: ClientSpec;
  readonly isExtension: boolean;
  readonly hereSinceMs: number;
}

/** Registered clients. */
export class ClientRegistry {
  /** Called when a client becomes reachable or unreachable: it may be a node [SE-31]. */
  readonly onPresence = new Hook<[client: Client]>();
  /** Called with each frame for a client of another master. [CU-24] */
  readonly onForeignFrame = new Hook<[client: Client, frame: Uint8Array]>();
  readonly #context: ClientContext;
  readonly #clients = new Map<string, Client>();
  readonly #publishLimits: PublishLimitTable;
  readonly #marks = new Marks();

  constructor(context: ClientContext) {
    this.#context = context;
    this.#publishLimits = new PublishLimitTable(context.limits.limits);
  }

  get size(): number {
    return this.#clients.size;
  }

  values(): Iterable<Client> {
    return this.#clients.values();
  }

  has(id: string): boolean {
    return this.#clients.has(id);
  }

  get(id: string): Client | undefined {
    return this.#clients.get(id);
  }

  /** @throws ServiceError when there is none, or the request named none. */
  require(id: string, member: string): Client {
    const client = this.#clients.get(id);
    if (client !== undefined) return client;
    if (id === '') {
      throw new ServiceError(
        'invalid_argument',
        `The request has no ${member}. Set it to the id that the registration returned.`,
      );
    }
    throw new ServiceError(
      'not_found',
      `The ${member} ${quote(id)} is not the id of a registered client. Register first.`,
    );
  }

  /** Sends a frame of topic data to a client at any master; drops it if the client is not connected. */
  sendFrame(client: Client, frame: Uint8Array): void {
    if (client.home === undefined) client.socket?.sendFrame(frame);
    else this.onForeignFrame.emit(client, frame);
  }

  /** A mark that no client has. [EX-100] */
  freeMark(): Mark {
    return this.#marks.free();
  }

  countByStatus(): Record<Exclude<ClientStatus, 'removed'>, number> {
    const counts = { active: 0, inactive: 0, unavailable: 0, removed: 0 };
    for (const { status, home } of this.#clients.values()) if (home === undefined) counts[status]++;
    return counts;
  }

  /**
   * Registers a client, or resumes an earlier one that proves its identity [CL-1] [CL-3] [CL-4].
   * @param access how it came in
   * @returns the client; whether it has the id it asked for; whether it was still known under it.
   * @throws ServiceError when there would be too many, or too much.
   */
  register(
    message: ClientMessage,
    access: ClientAccess,
  ): { client: Client; isResumed: boolean; isKnown: boolean } {
    const earlierId = this.provenId(message);
    const known = earlierId === undefined ? undefined : this.#clients.get(earlierId);
    const sentMs = sentMsOf(message);
    if (known?.home !== undefined) {
      requireNewest(known, sentMs);
      this.#requireTakeover(known, access); // [CU-21]
    }
    const hereSinceMs = this.#whenHere(known, sentMs);
    const client = known ?? this.#create(message, earlierId ?? this.#context.ids.uuid(), access);
    this.#describe(client, message);
    if (known?.home !== undefined) this.#takeOver(known, access);
    client.hereSinceMs = hereSinceMs;
    this.#admit(client, access);
    this.#setMark(client, this.#marks.decide(message.extension?.mark, client.mark));
    if (known !== undefined) this.handleSign(known);
    else {
      this.#clients.set(client.id, client);
      client.account.add(RESOURCE.clients, 1);
      this.#context.kept.handleReturn(client); // [TD-45]
      this.#context.dismissals.forget(client.id); // [EX-30]
      const isBack = earlierId !== undefined;
      this.#context.events.add(
        isBack ? StatusEventKind.CLIENT_RETURNED : StatusEventKind.CLIENT_JOINED,
        `${client.label} ${isBack ? 'came back' : 'joined'}`,
        client.id,
      );
    }
    this.onPresence.emit(client);
    return { client, isResumed: earlierId !== undefined, isKnown: known !== undefined };
  }

  /** The id this registration may have because it proves to be the one who had it [EX-3]. */
  provenId({ id, extension }: ClientMessage): string | undefined {
    const token = extension?.resumeToken ?? '';
    if (id === '' || token === '') return undefined;
    return this.#context.tokens.verify(id, token) ? id : undefined;
  }

  /**
   * Adds a client of another master.
   *
   * @param hereSinceMs when it came there, epoch milliseconds
   */
  addForeign(id: string, { home, spec, isExtension, hereSinceMs }: ForeignClientInit): Client {
    const { accounts, clock, createSubscriber } = this.#context;
    const account = accounts.createForeign(id);
    const nowMs = clock.monotonicMs();
    const client = new Client({
      id,
      spec,
      isExtension,
      account,
      nowMs,
      subscriber: createSubscriber(id, isExtension, account),
      publishLimits: this.#publishLimits.of(TRUSTED_ACCESS),
      epochMs: hereSinceMs,
    });
    client.home = home;
    this.#clients.set(id, client);
    account.add(RESOURCE.clients, 1);
    account.add(RESOURCE.registrationBytes, sizeOf(spec));
    return client;
  }

  /** What it may publish here, such as its part of a lockstep pass, is what its role gives. [CU-24] */
  admitForeign(client: Client, access: ClientAccess): void {
    const { devices, patterns } = this.#context;
    client.access = access;
    client.setPublishLimits(this.#publishLimits.of(access), this.#context.clock.monotonicMs());
    const scope = { clients: this.#clients, devices };
    const { publish } = topicRightsOf(client.id, access.role, access.grant, scope, patterns);
    client.publishRights = publish;
  }

  /** What its master says of a client of another master is so. */
  setForeign(
    client: Client,
    { spec, status, mark }: { spec: ClientSpec; status: ClientStatus; mark: Mark | undefined },
  ): void {
    client.account.add(RESOURCE.registrationBytes, sizeOf(spec) - sizeOf(client.spec));
    client.spec = spec;
    client.ownName = spec.name;
    this.#setMark(client, isMark(mark) ? mark : undefined);
    client.registrationRevision++;
    if (client.status !== status) client.statusSinceMs = this.#context.clock.monotonicMs();
    client.status = status;
    this.#context.info.announceClient(client);
    this.onPresence.emit(client);
  }

  /** A client that was here is at another master now: its connection ends, and nothing else of it. [CU-22] */
  giveAway(client: Client, home: ClientHome): void {
    const { kept, topics, subscriptions, accounts } = this.#context;
    client.home = home;
    client.socket?.close('superseded');
    for (const entry of [...client.ownedTopics]) topics.deleteValue(entry);
    kept.deleteOf(client.id);
    subscriptions.unsubscribeAll(client.subscriber);
    client.subscriber.outbox.discard();
    client.subscriber.sampler.discard();
    client.publishRights = undefined;
    client.subscriber.readRights = undefined;
    accounts.moveOut(client.account);
  }

  /** Its master is lost: it has to come back, to this master or to another one. [CU-21] */
  handleHomeLost(client: Client): void {
    client.lastSignMs = this.#context.clock.monotonicMs();
    this.handleEvent(client, 'socket closed');
  }

  /** The client was active [CL-11]. */
  handleSign(client: Client): void {
    client.lastSignMs = this.#context.clock.monotonicMs();
    if (client.status !== 'active') this.handleEvent(client, 'sign');
  }

  /** Moves the client to the state that follows, with everything that goes with it [CL-10]. */
  handleEvent(client: Client, event: ClientEvent): void {
    const before = client.status;
    const status = nextStatus(before, event);
    if (status === before) return;
    client.status = status;
    client.statusSinceMs = this.#context.clock.monotonicMs();
    const { events, info } = this.#context;
    if (status === 'removed') return this.#remove(client, event);
    if (status === 'unavailable') {
      this.#endTopics(client); // [CL-13]
      events.add(StatusEventKind.CLIENT_LOST, `${client.label} lost its connection`, client.id);
    } else if (before === 'unavailable') {
      this.#context.kept.handleReturn(client); // [TD-45]
      events.add(StatusEventKind.CLIENT_RETURNED, `${client.label} is back`, client.id);
    }
    info.announceClient(client); // [CL-31]
    if (status === 'unavailable' || status === 'active') this.onPresence.emit(client);
  }

  /**
   * Renames a client, and announces the new name to all others [EX-29] [CL-31].
   * @throws ServiceError when there is no room for it
   */
  rename(client: Client, name: string): void {
    const spec = { ...client.spec, name };
    this.#resize(client, sizeOf(spec) - sizeOf(client.spec));
    client.spec = spec;
    this.#context.info.announceClient(client);
  }

  /** Removes a client at the request of an admin. The client gets the reason, now or when it reconnects [EX-30]. */
  dismiss(client: Client, dismissal: Dismissal): void {
    this.#context.dismissals.add(client.id, dismissal);
    client.socket?.close(dismissal.reason, dismissal.explanation);
    this.handleEvent(client, 'deregistered');
  }

  /** Removes clients that are away, until there is room [AC-84]. */
  makeRoom(shortage: Shortage, hasRoom: () => boolean): void {
    if (hasRoom()) return;
    for (const client of leastMissed(this.#clients.values(), shortage)) {
      this.handleEvent(client, 'expired');
      if (hasRoom()) return;
    }
  }

  /** @throws ServiceError when there is no room for a client of another master */
  #requireTakeover({ account }: Client, access: ClientAccess): void {
    const { accounts } = this.#context;
    const share = accounts.ofShare(shareOf(access));
    for (const resource of [RESOURCE.clients, RESOURCE.registrationBytes, RESOURCE.devices]) {
      accounts.require(share, resource, account.used(resource));
    }
  }

  /** When a client comes here that registers now: later than it came to where it was. [CU-22] [EX-51] */
  #whenHere(known: Client | undefined, sentMs: number | undefined): number {
    const nowMs = this.#context.clock.nowMs();
    if (known === undefined) return sentMs ?? nowMs;
    if (sentMs === undefined) return Math.max(nowMs, known.hereSinceMs + 1);
    return known.home === undefined ? Math.max(sentMs, known.hereSinceMs) : sentMs;
  }

  /** A client of another master has come here. */
  #takeOver(client: Client, access: ClientAccess): void {
    const { accounts } = this.#context;
    client.home = undefined;
    client.publishRights = undefined;
    client.access = TRUSTED_ACCESS; // whose rights it has until it is admitted
    accounts.move(client.account, shareOf(access));
    const text = `${client.label} came from another master`;
    this.#context.events.add(StatusEventKind.CLIENT_RETURNED, text, client.id);
  }

  #create(message: ClientMessage, id: string, access: ClientAccess): Client {
    const { clock, createSubscriber, accounts } = this.#context;
    const account = accounts.createClient(id, shareOf(access));
    accounts.require(account, RESOURCE.clients, 1);
    const nowMs = clock.monotonicMs();
    const isExtension = message.extension !== undefined; // [EX-1]
    return new Client({
      id,
      spec: specOf(message),
      isExtension,
      account,
      subscriber: createSubscriber(id, isExtension, account),
      publishLimits: this.#publishLimits.of(access),
      nowMs,
      epochMs: clock.nowMs(),
    });
  }

  /** Takes over what the client says of itself, if there is room for it. */
  #describe(client: Client, message: ClientMessage): void {
    const described = specOf(message);
    // A renamed client keeps the name until it sends another name itself. [EX-29]
    const isSameName = described.name === client.ownName;
    const spec = isSameName ? { ...described, name: client.spec.name } : described;
    const growth = sizeOf(spec) - (this.#clients.has(client.id) ? sizeOf(client.spec) : 0);
    this.#resize(client, growth);
    if (!areEqual(bytesOf(spec), bytesOf(client.spec))) client.registrationRevision++;
    client.spec = spec;
    client.ownName = described.name;
    client.library = message.extension?.library ?? ''; // [EX-25]
    client.node = client.isExtension ? message.extension?.node : undefined; // [PM-60]
    client.subscriber.outbox.sendsDeletions = client.node !== undefined; // [TD-42]
    client.takesRecordLists = message.extension?.recordLists ?? false; // [EX-2]
    client.socket?.setRecordLists(client.takesRecordLists);
  }

  /** Gives it the rights that go with how it came in. */
  #admit(client: Client, access: ClientAccess): void {
    const { access: before, subscriber } = client;
    client.access = access;
    this.#context.accounts.move(client.account, shareOf(access));
    if (before.role === access.role && before.grant === access.grant) return;
    const { devices, patterns, clock } = this.#context;
    client.setPublishLimits(this.#publishLimits.of(access), clock.monotonicMs());
    const { publish, read } = topicRightsOf(
      client.id,
      access.role,
      access.grant,
      { clients: this.#clients, devices },
      patterns,
    );
    client.publishRights = publish;
    const hadAll = subscriber.readRights === undefined;
    subscriber.readRights = read;
    // A new client has no subscriptions, so the topics need no update.
    if ((hadAll && read === undefined) || !this.#clients.has(client.id)) return;
    this.#context.subscriptions.handleRightsChanged(subscriber);
  }

  /** Takes room for what a client registered, or with a negative number gives it back. */
  #resize({ account }: Client, growthBytes: number): void {
    const resource = RESOURCE.registrationBytes;
    if (growthBytes > 0) this.#context.accounts.require(account, resource, growthBytes);
    account.add(resource, growthBytes);
  }

  #setMark(client: Client, mark: Mark | undefined): void {
    this.#marks.count(client.mark, -1);
    this.#marks.count(mark, 1);
    client.mark = mark;
  }

  #remove(client: Client, event: ClientEvent): void {
    const { events, devices, subscriptions, info, accounts } = this.#context;
    client.socket?.close('deregistered'); // [CL-16]
    devices.deregisterAll(client);
    this.#endTopics(client); // [TD-40]
    subscriptions.unsubscribeAll(client.subscriber);
    client.subscriber.outbox.discard();
    client.subscriber.sampler.discard();
    this.#clients.delete(client.id);
    this.#marks.count(client.mark, -1);
    const { account } = client;
    account.add(RESOURCE.registrationBytes, -account.used(RESOURCE.registrationBytes));
    account.add(RESOURCE.clients, -1);
    accounts.close(account);
    // A client removed by an admin is announced as such.
    const isDismissed = this.#context.dismissals.of(client.id) !== undefined;
    if (event === 'deregistered' && !isDismissed) {
      events.add(StatusEventKind.CLIENT_LEFT, `${client.label} left`, client.id);
    }
    info.announceClientGone(client); // [CL-31]
    this.onPresence.emit(client);
  }

  #endTopics(client: Client): void {
    const { kept, topics, dismissals } = this.#context;
    if (dismissals.of(client.id) === undefined) {
      kept.handleAbsent(client, shareOf(client.access)); // [TD-43]
      return;
    }
    for (const entry of [...client.ownedTopics]) topics.deleteValue(entry);
    kept.deleteOf(client.id); // [TD-46]
  }
}

function sizeOf(spec: ClientSpec): number {
  return bytesOf(spec).byteLength;
}

function bytesOf(spec: ClientSpec): Uint8Array {
  return encode('ubii.clients.Client', spec);
}

/** When the client sent this, by its own clock; undefined when it does not say. [EX-51] */
function sentMsOf({ extension }: ClientMessage): number | undefined {
  const sentMs = extension?.sentMs ?? 0;
  return Number.isFinite(sentMs) && sentMs > 0 ? sentMs : undefined;
}

/**
 * A registration that a broken network held back does not take a client from the master that it went to since. [EX-51]
 * @throws ServiceError for an older one
 */
function requireNewest({ home, hereSinceMs }: Client, sentMs: number | undefined): void {
  if (home?.isLost === true || sentMs === undefined || sentMs > hereSinceMs) return;
  throw new ServiceError(
    'failed_precondition',
    'This registration is older than the one with which the client came to another master. Register again.',
  );
}
