import type { LoadConnection, StreamReceiver } from '../load/load-connection.ts';

/** A broker together with the kind of clients that use it. */
export type TargetName = 'raw-ws' | 'ubii-extension' | 'ubii-legacy';

/** The target all others are divided by. */
export const REFERENCE: TargetName = 'raw-ws';

/** Publications and subscriptions of a client. */
export interface ClientRole {
  readonly publishes: boolean;
  /** Topics it receives; raw-ws knows none and sends everything. */
  readonly topics: readonly string[];
  /** Regular expressions of topics that it subscribes to as well; raw-ws knows none. */
  readonly patterns?: readonly string[];
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
  /** @param receiver takes what the broker sends */
  join(role: ClientRole, receiver: StreamReceiver): Promise<BrokerClient>;
}

/** A broker process. Two targets may share it. */
export interface Broker {
  readonly targets: readonly Target[];
  stop(): Promise<void>;
}
