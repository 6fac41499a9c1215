import type { Client as ClientMessage, Device, Mark, NodeExtension } from '@ubii/proto';
import type { ToldClock } from '@ubii/proto/wire';
import { TokenBucket } from '@ubii/timing';
import { TRUSTED_ACCESS, type ClientAccess } from '../access/caller.ts';
import type { AddressKind } from '../ports/address-kind.ts';
import type { Account } from '../shares/account.ts';
import { Streak } from '../counters/streak.ts';
import type { PublishingClient } from '../topics/publication.ts';
import type { PublishLimits } from '../topics/publish-limits.ts';
import type { ClientSubscriber } from '../topics/subscriber.ts';
import type { PublishRights } from '../topics/rights.ts';
import type { TopicEntry } from '../topics/topic-entry.ts';
import type { ClientSocket } from './client-socket.ts';
import { wireState, type ClientStatus } from './client-states.ts';
import type { Throttle } from '../counters/throttle.ts';
import { Traffic } from './traffic.ts';

/** Registration of a client without its id, state, devices and secrets. */
export type ClientSpec = Omit<ClientMessage, 'id' | 'devices' | 'state' | 'latency' | 'extension'>;

/** Fixed properties of a client. */
export interface ClientInit {
  readonly id: string;
  readonly spec: ClientSpec;
  readonly isExtension: boolean;
  readonly account: Account;
  readonly subscriber: ClientSubscriber;
  readonly publishLimits: PublishLimits;
  /** Monotonic and epoch milliseconds. */
  readonly nowMs: number;
  readonly epochMs: number;
}

/** The peer of a socket, as far as the transport knows it [EX-25]. */
export interface Peer {
  /** Name of its program; empty when it says none. */
  readonly program: string;
  readonly addressKind: AddressKind | undefined;
  /** The same for clients of one address [EX-99]; empty before the first socket. */
  readonly addressGroup: string;
}

/** Another master, which a client is connected to. [CU-20] */
export interface ClientHome {
  readonly masterId: string;
  /** It does not answer any more: the client has to come to another master. */
  isLost: boolean;
}

/** A registered client. Times are monotonic milliseconds. */
export class Client implements PublishingClient {
  readonly id: string;
  /** It sent `Client.extension` at registration [EX-1]. */
  readonly isExtension: boolean;
  /** Its use of limited resources [AC-80]. */
  readonly account: Account;
  readonly subscriber: ClientSubscriber;
  #publishLimits: PublishLimits;
  recordBudget: TokenBucket;
  byteBudget: TokenBucket;
  readonly traffic = new Traffic();
  readonly ownedTopics = new Set<TopicEntry>();
  readonly devices = new Map<string, Device>();

  /** Grows with every change of its devices, and of what it says of itself [EX-74]. */
  registrationRevision = 0;
  spec: ClientSpec;
  /** The name that the client sent; `spec` has another name when an admin renamed the client [EX-29]. */
  ownName: string;
  /** Name and version of its library; empty when it does not say. */
  library = '';
  /** Of its last socket. */
  peer: Peer = { program: '', addressKind: undefined, addressGroup: '' };
  /** When it opened its socket, epoch milliseconds. */
  socketOpenedMs = 0;
  /** The same by its own clock, later than of every socket before; undefined when it did not say. [EX-51] */
  socketSentMs: number | undefined = undefined;
  /** When it registered, epoch milliseconds. */
  readonly firstSeenMs: number;
  /** The master it is connected to; undefined: this one. */
  home: ClientHome | undefined = undefined;
  /** When it came to its master, epoch milliseconds by its own clock if it says: its newest place counts. [CU-22] */
  hereSinceMs: number;
  throttle: Throttle | undefined = undefined;
  /** Kind of access and role. [AC-20] */
  access: ClientAccess = TRUSTED_ACCESS;
  publishRights: PublishRights | undefined = undefined;
  /** Shape and colour that people know it by; `undefined` until it has one. [EX-100] */
  mark: Mark | undefined = undefined;
  /** Its capabilities as a node; undefined when it is not a node [PM-60]. */
  node: NodeExtension | undefined = undefined;
  /** Takes lists of records [EX-2]. */
  takesRecordLists = false;
  status: ClientStatus = 'active';
  statusSinceMs: number;
  lastSignMs: number;
  socket: ClientSocket | undefined = undefined;
  /** Number of the newest record of all when its last frame came; undefined before its first socket. */
  heardSequence: number | undefined = undefined;
  /** When the last PING left that was not answered yet. */
  pingSentMs: number | undefined = undefined;
  readonly protocolErrors = new Streak();
  latencyMs = 0;
  /** Last report of its clock, with the time; undefined without one [TS-10]. */
  clock: (ToldClock & { readonly toldMs: number }) | undefined = undefined;
  latencyMeasuredMs: number;

  constructor(parts: ClientInit) {
    this.id = parts.id;
    this.spec = parts.spec;
    this.ownName = parts.spec.name;
    this.firstSeenMs = parts.epochMs;
    this.hereSinceMs = parts.epochMs;
    this.isExtension = parts.isExtension;
    this.account = parts.account;
    this.subscriber = parts.subscriber;
    this.#publishLimits = parts.publishLimits;
    this.recordBudget = this.#newRecordBudget(parts.nowMs);
    this.byteBudget = this.#newByteBudget(parts.nowMs);
    this.statusSinceMs = parts.nowMs;
    this.lastSignMs = parts.nowMs;
    this.latencyMeasuredMs = parts.nowMs;
  }

  get publishLimits(): PublishLimits {
    return this.#publishLimits;
  }

  /** Holds the client to other limits than before, such as those of another role. [TD-70] */
  setPublishLimits(limits: PublishLimits, nowMs: number): void {
    if (limits === this.#publishLimits) return;
    this.#publishLimits = limits;
    this.byteBudget = this.#newByteBudget(nowMs);
    if (this.throttle === undefined) this.endThrottle(nowMs);
  }

  /** From now on only the limits of its role hold. */
  endThrottle(nowMs: number): void {
    this.throttle = undefined;
    this.recordBudget = this.#newRecordBudget(nowMs);
  }

  /** The client as others may see it [CL-23]. */
  toMessage(): Omit<ClientMessage, 'extension'> {
    return {
      ...this.spec,
      id: this.id,
      devices: [...this.devices.values()],
      state: wireState(this.status),
      latency: this.latencyMs,
    };
  }

  #newRecordBudget(nowMs: number): TokenBucket {
    return new TokenBucket(this.#publishLimits.recordsPerSecond.value, nowMs);
  }

  #newByteBudget(nowMs: number): TokenBucket {
    return new TokenBucket(this.#publishLimits.bytesPerSecond.value, nowMs);
  }

  /** Name and id as they stand in messages for people. */
  get label(): string {
    return this.spec.name === '' ? this.id : this.spec.name;
  }
}

/** Takes from a registration what is kept of it; devices are registered on their own [CL-5]. */
export function specOf(message: ClientMessage): ClientSpec {
  const { name, tags, description, processingModules } = message;
  const { isDedicatedProcessingNode, hostIp, metadataJson } = message;
  return {
    name,
    tags,
    description,
    processingModules,
    isDedicatedProcessingNode,
    hostIp,
    metadataJson,
  };
}
