import type { ConnectionState, RoundTrip, UbiiClient } from '@ubii/client-web';
import type { Mark } from '@ubii/proto';
import type { ComputedRef, InjectionKey, Ref, ShallowRef } from 'vue';
import type { ClientReportsStore } from './client-reports-store.ts';
import type { ClientsStore } from './clients-store.ts';
import type { MasterStatusStore } from './master-status-store.ts';
import type { NodesStore } from './nodes-store.ts';
import type { SessionsStore } from './sessions-store.ts';
import type { TopicStatisticsStore } from './topic-statistics-store.ts';

/** Shape and colour by which others know this page. */
export interface OwnMark {
  /** As the master has it; before the first connection, as it was kept. */
  readonly current: Readonly<ShallowRef<Mark | undefined>>;
  /** The kept one; `undefined` before the first choice. */
  readonly kept: Readonly<ShallowRef<Mark | undefined>>;
  /** Keeps a mark and tells the master; `chosen` takes it also when another client has it. */
  set(mark: Mark): void;
}

/** Connection of this page to the system. Views read its state and call its methods. */
export interface Connection {
  readonly client: UbiiClient;
  readonly state: Readonly<ShallowRef<ConnectionState>>;
  readonly isConnected: ComputedRef<boolean>;
  /** True when another page uses this identity; no retries until `connect()`. */
  readonly isSuperseded: ComputedRef<boolean>;
  readonly roundTrip: Readonly<ShallowRef<RoundTrip | undefined>>;
  /**
   * Name of this tab: that of the browser, with a number from the second tab on. Stored; assign to rename the browser.
   */
  readonly name: Ref<string>;
  /** Mark of this browser's person, kept for the next time; `undefined` before one was chosen or given. [EX-100] */
  readonly mark: OwnMark;
  /** Interval at which published records are batched, milliseconds; stored. */
  readonly publishIntervalMs: Ref<number>;
  readonly master: MasterStatusStore;
  /** Client id of the master as publisher of its modules' outputs; empty until known. */
  readonly masterId: Readonly<ShallowRef<string>>;
  readonly clients: ClientsStore;
  readonly reports: ClientReportsStore;
  readonly topics: TopicStatisticsStore;
  readonly sessions: SessionsStore;
  readonly nodes: NodesStore;
  /** Connects, or retries at once. */
  connect(): void;
  /** Disconnects; `connect()` resumes as the same client. */
  leave(): void;
  /** Disconnects, discards the identity, and connects as a new client. */
  forgetIdentity(): Promise<void>;
}

export const CONNECTION: InjectionKey<Connection> = Symbol('connection');
