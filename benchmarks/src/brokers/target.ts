import type { LoadConnection } from '../load/load-connection.ts';
import type { RecordRing } from '../load/record-ring.ts';

/** What is measured: a broker together with the kind of clients that use it. */
export type TargetName = 'raw-ws' | 'ubii-extension' | 'ubii-legacy';

/** The target all others are divided by. */
export const REFERENCE: TargetName = 'raw-ws';

/** What a client does on the topic of the ring. */
export interface ClientRole {
  readonly publishes: boolean;
  readonly subscribes: boolean;
}

/** One client of a broker, connected and, if it wants to be, subscribed. */
export interface BrokerClient {
  readonly connection: LoadConnection;
  /** Leaves the broker as if it had never been there. */
  leave(): Promise<void>;
}

/** A running broker and one way to connect to it. */
export interface Target {
  readonly name: TargetName;
  /** Process whose CPU time is counted. */
  readonly pid: number;
  join(role: ClientRole, ring: RecordRing): Promise<BrokerClient>;
}

/** A broker process. Two targets may share it. */
export interface Broker {
  readonly targets: readonly Target[];
  stop(): Promise<void>;
}
