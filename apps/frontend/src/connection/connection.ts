import type { ConnectionState, RoundTrip, UbiiClient } from '@ubii/client-web';
import type { ComputedRef, InjectionKey, Ref, ShallowRef } from 'vue';
import type { ClientReportsStore } from './client-reports-store.ts';
import type { ClientsStore } from './clients-store.ts';
import type { MasterStatusStore } from './master-status-store.ts';
import type { NodesStore } from './nodes-store.ts';
import type { SessionsStore } from './sessions-store.ts';
import type { TopicStatisticsStore } from './topic-statistics-store.ts';

/** This page's one place in the system. Views read it and send intents. */
export interface Connection {
  readonly client: UbiiClient;
  readonly state: Readonly<ShallowRef<ConnectionState>>;
  readonly isConnected: ComputedRef<boolean>;
  /** Another page has taken this identity; nothing is retried until `connect()`. */
  readonly isSuperseded: ComputedRef<boolean>;
  readonly roundTrip: Readonly<ShallowRef<RoundTrip | undefined>>;
  /** This tab's name: that of the browser, remembered, from the second tab on with a number. Assign to rename the browser. */
  readonly name: Ref<string>;
  /** How long published records are collected before they are sent, milliseconds, remembered. */
  readonly publishIntervalMs: Ref<number>;
  readonly master: MasterStatusStore;
  /** Publisher of what modules on the master put out; empty until it is known. */
  readonly masterId: Readonly<ShallowRef<string>>;
  readonly clients: ClientsStore;
  readonly reports: ClientReportsStore;
  readonly topics: TopicStatisticsStore;
  readonly sessions: SessionsStore;
  readonly nodes: NodesStore;
  /** Connects, or tries again at once. */
  connect(): void;
  /** Leaves; `connect()` comes back as the same client. */
  leave(): void;
  /** Leaves, forgets who this page was and comes back as a new client. */
  forgetIdentity(): Promise<void>;
}

export const CONNECTION: InjectionKey<Connection> = Symbol('connection');
