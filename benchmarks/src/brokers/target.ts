import type { StreamReceiver } from '../load/load-connection.ts';
import type { Wire } from '../load/wire.ts';

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
  /** In place of topics and patterns for raw-ws. Default: one for all */
  readonly rooms?: { readonly publish: string; readonly subscribe: string };
}

/** One client of a broker, connected and, if it wants to be, subscribed. */
export interface BrokerClient {
  readonly connection: {
    /** Sends bytes that are whole messages already. */
    send(messages: Buffer): void;
    close(): Promise<void>;
  };
  /** Leaves the broker as if it had never been there. */
  leave(): Promise<void>;
}

/** One way for clients to reach a broker, or several that work together. */
export interface Access {
  /** Processes whose CPU time is counted. */
  readonly pids: readonly number[];
  /** Default: WebSocket */
  readonly wire?: Wire;
  /** @param receiver takes what the broker sends */
  join(role: ClientRole, receiver: StreamReceiver): Promise<BrokerClient>;
}

/** A running broker and one way to connect to it. */
export interface Target extends Access {
  readonly name: TargetName;
  /** Its process. */
  readonly pid: number;
}

/** A broker process. Two targets may share it. */
export interface Broker {
  readonly targets: readonly Target[];
  stop(): Promise<void>;
}
