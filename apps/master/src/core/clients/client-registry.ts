import { encode, ServiceError, StatusEventKind, type Client as ClientMessage } from '@ubii/proto';
import type { ClientAccess } from '../access/caller.ts';
import type { TopicRights } from '../access/topic-rights.ts';
import type { DeviceRegistry } from '../devices/device-registry.ts';
import type { InfoTopics } from '../info/info-topics.ts';
import type { Clock } from '../ports/clock.ts';
import type { IdSource } from '../ports/id-source.ts';
import type { ResumeTokens } from '../ports/resume-tokens.ts';
import type { EventLog } from '../status/event-log.ts';
import type { LimitWatch } from '../status/limit-watch.ts';
import type { SubscriptionTable } from '../topics/subscription-table.ts';
import type { ClientSubscriber } from '../topics/subscriber.ts';
import { TokenBucket } from '../topics/token-bucket.ts';
import { quote } from '../topics/topic-names.ts';
import type { TopicTable } from '../topics/topic-table.ts';
import { oneLine } from '../one-line.ts';
import { Client, specOf, type ClientSpec } from './client.ts';
import { closeReason } from './close-reason.ts';
import { CLOSE } from './close-codes.ts';
import type { Dismissals } from './dismissals.ts';
import { nextStatus, type ClientEvent, type ClientStatus } from './client-states.ts';
import type { RegistrationBudget } from './registration-budget.ts';

/** Characters kept of what a client says of its library [EX-25]. */
const MAX_LIBRARY_LENGTH = 64;

/** What a client registry works on. */
export interface ClientContext {
  readonly clock: Clock;
  readonly ids: IdSource;
  readonly tokens: ResumeTokens;
  readonly limits: LimitWatch;
  readonly events: EventLog;
  readonly topics: TopicTable;
  readonly subscriptions: SubscriptionTable;
  readonly devices: DeviceRegistry;
  readonly info: InfoTopics;
  readonly budget: RegistrationBudget;
  readonly createSubscriber: (clientId: string, isExtension: boolean) => ClientSubscriber;
  /** What a client that came in like this may do on topics [AC-24] [AC-25]. */
  readonly topicRightsOf: (clientId: string, access: ClientAccess) => TopicRights;
  readonly dismissals: Dismissals;
  /** The client can be reached now, or no longer: as a node it matters [SE-31]. */
  readonly onPresence: (client: Client) => void;
}

/** Every registered client, and what becomes of it. */
export class ClientRegistry {
  readonly #context: ClientContext;
  readonly #clients = new Map<string, Client>();

  constructor(context: ClientContext) {
    this.#context = context;
  }

  get size(): number {
    return this.#clients.size;
  }

  values(): Iterable<Client> {
    return this.#clients.values();
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
        `The request has no ${member}; put there the id that the registration returned.`,
      );
    }
    throw new ServiceError(
      'not_found',
      `The ${member} ${quote(id)} is the id of no registered client; register first.`,
    );
  }

  countByStatus(): Record<Exclude<ClientStatus, 'removed'>, number> {
    const counts = { active: 0, inactive: 0, unavailable: 0, removed: 0 };
    for (const { status } of this.#clients.values()) counts[status]++;
    return counts;
  }

  /**
   * Registers a client, or takes back an earlier one that proves who it is [CL-1] [CL-3] [CL-4].
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
    const client = known ?? this.#create(message, earlierId ?? this.#context.ids.uuid());
    this.#describe(client, message);
    this.#admit(client, access);
    if (known !== undefined) this.handleSign(known);
    else {
      this.#clients.set(client.id, client);
      this.#context.dismissals.forget(client.id); // [EX-30]
      const isBack = earlierId !== undefined;
      this.#context.events.add(
        isBack ? StatusEventKind.CLIENT_RETURNED : StatusEventKind.CLIENT_JOINED,
        `${client.label} ${isBack ? 'came back' : 'joined'}`,
        client.id,
      );
    }
    this.#context.onPresence(client);
    return { client, isResumed: earlierId !== undefined, isKnown: known !== undefined };
  }

  /** The id this registration may have because it proves to be the one who had it [EX-3]. */
  provenId({ id, extension }: ClientMessage): string | undefined {
    const token = extension?.resumeToken ?? '';
    if (id === '' || token === '') return undefined;
    return this.#context.tokens.verify(id, token) ? id : undefined;
  }

  /** The client gave a sign of life [CL-11]. */
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
      events.add(StatusEventKind.CLIENT_LOST, `${client.label} is gone without a word`, client.id);
    } else if (before === 'unavailable') {
      events.add(StatusEventKind.CLIENT_RETURNED, `${client.label} is back`, client.id);
    }
    info.announceClient(client); // [CL-31]
    if (status === 'unavailable' || status === 'active') this.#context.onPresence(client);
  }

  /**
   * Gives a client another name, which all others hear of [EX-29] [CL-31].
   * @throws ServiceError when there is no room for it
   */
  rename(client: Client, name: string): void {
    const { budget, info } = this.#context;
    const spec = { ...client.spec, name };
    const growth = sizeOf(spec) - sizeOf(client.spec);
    budget.require(client, growth);
    budget.add(client, growth);
    client.spec = spec;
    info.announceClient(client);
  }

  /** Removes a client because somebody wants it gone; it is told why, now or when it comes back [EX-30]. */
  dismiss(client: Client, why: string, code: number = CLOSE.disconnected.code): void {
    const reason = closeReason(why);
    this.#context.dismissals.add(client.id, { code, reason });
    client.socket?.close(code, reason);
    this.handleEvent(client, 'deregistered');
  }

  #create(message: ClientMessage, id: string): Client {
    const { limits, clock, createSubscriber } = this.#context;
    const { clients, recordsPerSecond, publishedBytesPerSecond } = limits.limits;
    if (this.#clients.size >= clients && !this.#makeRoom()) {
      throw limits.refusal('clients', `more than ${clients} clients`);
    }
    const nowMs = clock.monotonicMs();
    const isExtension = message.extension !== undefined; // [EX-1]
    return new Client({
      id,
      spec: specOf(message),
      isExtension,
      subscriber: createSubscriber(id, isExtension),
      recordBudget: new TokenBucket(recordsPerSecond, nowMs),
      byteBudget: new TokenBucket(publishedBytesPerSecond, nowMs),
      nowMs,
      epochMs: clock.nowMs(),
    });
  }

  /** Takes over what the client says of itself, if there is room for it. */
  #describe(client: Client, message: ClientMessage): void {
    const { budget } = this.#context;
    const described = specOf(message);
    // What somebody renamed keeps that name until it says another one itself. [EX-29]
    const isSameName = described.name === client.ownName;
    const spec = isSameName ? { ...described, name: client.spec.name } : described;
    const growth = sizeOf(spec) - (this.#clients.has(client.id) ? sizeOf(client.spec) : 0);
    budget.require(client, growth);
    budget.add(client, growth);
    client.spec = spec;
    client.ownName = described.name;
    client.library = oneLine(message.extension?.library ?? '', MAX_LIBRARY_LENGTH); // [EX-25]
    client.node = client.isExtension ? message.extension?.node : undefined; // [PM-60]
    client.subscriber.outbox.hearsOfGone = client.node !== undefined; // [TD-42]
    client.takesRecordLists = message.extension?.recordLists ?? false; // [EX-2]
    client.socket?.setRecordLists(client.takesRecordLists);
  }

  /** Gives it the rights that go with how it came in. */
  #admit(client: Client, access: ClientAccess): void {
    const { access: before, subscriber } = client;
    client.access = access;
    if (before.role === access.role && before.grant === access.grant) return;
    const { publish, read } = this.#context.topicRightsOf(client.id, access);
    client.publishRights = publish;
    const hadAll = subscriber.readRights === undefined;
    subscriber.readRights = read;
    // Who is new has no subscriptions, and the topics need not be gone through.
    if ((hadAll && read === undefined) || !this.#clients.has(client.id)) return;
    this.#context.subscriptions.handleRightsChanged(subscriber);
  }

  /** When the house is full, whoever has been away longest makes room, those first who never had a socket. */
  #makeRoom(): boolean {
    let goes: Client | undefined;
    for (const client of this.#clients.values()) {
      if (client.status !== 'unavailable') continue;
      if (goes === undefined || isLessMissed(client, goes)) goes = client;
    }
    if (goes === undefined) return false;
    this.handleEvent(goes, 'expired');
    return true;
  }

  #remove(client: Client, event: ClientEvent): void {
    const { events, devices, subscriptions, info, budget } = this.#context;
    client.socket?.close(1000, 'deregistered'); // [CL-16]
    devices.deregisterAll(client);
    this.#endTopics(client); // [TD-40]
    subscriptions.unsubscribeAll(client.subscriber);
    client.subscriber.outbox.discard();
    client.subscriber.sampler.discard();
    this.#clients.delete(client.id);
    budget.add(client, -client.registrationBytes);
    // Of one that somebody removed, that is told instead.
    const isDismissed = this.#context.dismissals.of(client.id) !== undefined;
    if (event === 'deregistered' && !isDismissed) {
      events.add(StatusEventKind.CLIENT_LEFT, `${client.label} left`, client.id);
    }
    info.announceClientGone(client); // [CL-31]
    this.#context.onPresence(client);
  }

  #endTopics(client: Client): void {
    for (const entry of [...client.ownedTopics]) this.#context.topics.deleteValue(entry);
  }
}

function isLessMissed(client: Client, other: Client): boolean {
  const isStranger = client.heardSequence === undefined;
  const isOtherStranger = other.heardSequence === undefined;
  return isStranger === isOtherStranger ? client.statusSinceMs < other.statusSinceMs : isStranger;
}

function sizeOf(spec: ClientSpec): number {
  return encode('ubii.clients.Client', spec).byteLength;
}
