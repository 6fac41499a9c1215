import type { Client as ClientMessage, Device, NodeExtension } from '@ubii/proto';
import { Streak } from '../status/streak.ts';
import type { PublishingClient } from '../topics/publication.ts';
import type { ClientSubscriber } from '../topics/subscriber.ts';
import type { TokenBucket } from '../topics/token-bucket.ts';
import type { TopicEntry } from '../topics/topic-entry.ts';
import { wireState, type ClientStatus } from './client-states.ts';
import type { TopicDataSocket } from './topic-data-socket.ts';

/** What a client said of itself: everything but its id, state and devices, and without secrets. */
export type ClientSpec = Omit<ClientMessage, 'id' | 'devices' | 'state' | 'latency' | 'extension'>;

/** What makes a client, once. */
export interface ClientParts {
  readonly id: string;
  readonly spec: ClientSpec;
  readonly isExtension: boolean;
  readonly subscriber: ClientSubscriber;
  readonly recordBudget: TokenBucket;
  readonly byteBudget: TokenBucket;
  readonly nowMs: number;
}

/** A registered client. Times are monotonic milliseconds. */
export class Client implements PublishingClient {
  readonly id: string;
  /** It sent `Client.extension` at registration [EX-1]. */
  readonly isExtension: boolean;
  readonly subscriber: ClientSubscriber;
  readonly recordBudget: TokenBucket;
  readonly byteBudget: TokenBucket;
  readonly ownedTopics = new Set<TopicEntry>();
  readonly devices = new Map<string, Device>();

  spec: ClientSpec;
  /** What it said of itself as a node; undefined when it is none [PM-60]. */
  node: NodeExtension | undefined = undefined;
  /** Takes lists of records [EX-2]. */
  takesRecordLists = false;
  /** Encoded bytes of what it registered, devices included. */
  registrationBytes = 0;
  status: ClientStatus = 'active';
  statusSinceMs: number;
  lastSignMs: number;
  socket: TopicDataSocket | undefined = undefined;
  /** Number of the newest record of all when its last frame came; undefined before its first socket. */
  heardSequence: number | undefined = undefined;
  /** When the last PING left that was not answered yet. */
  pingSentMs: number | undefined = undefined;
  readonly protocolErrors = new Streak();
  latencyMs = 0;
  latencyMeasuredMs: number;

  constructor(parts: ClientParts) {
    this.id = parts.id;
    this.spec = parts.spec;
    this.isExtension = parts.isExtension;
    this.subscriber = parts.subscriber;
    this.recordBudget = parts.recordBudget;
    this.byteBudget = parts.byteBudget;
    this.statusSinceMs = parts.nowMs;
    this.lastSignMs = parts.nowMs;
    this.latencyMeasuredMs = parts.nowMs;
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
