import type { ConnectionError } from './connection-error.ts';

/** How the client and its master stand. A terminal `closed` carries the reason. */
export type ConnectionState =
  | { readonly status: 'idle' }
  | {
      readonly status: 'connecting';
      /** 1 for the first attempt. */
      readonly attempt: number;
    }
  | {
      readonly status: 'connected';
      readonly clientId: string;
      /** True when the client came back under the id it had. */
      readonly resumed: boolean;
      /** Semantic version of the master; `undefined` for an original master. */
      readonly masterVersion: string | undefined;
      /** Since when: milliseconds since the Unix epoch, this machine's clock. */
      readonly sinceMs: number;
    }
  | {
      readonly status: 'reconnecting';
      /** The attempt that is under way or comes next, counted from the last connection, the first is 1. */
      readonly attempt: number;
      /** When that attempt starts or started: milliseconds since the Unix epoch. */
      readonly nextAttemptMs: number;
      /** Why the last attempt, or the link, failed. */
      readonly error: ConnectionError;
    }
  | {
      readonly status: 'closed';
      /** `undefined` after `close()`; else why the client will not try again by itself. */
      readonly error: ConnectionError | undefined;
    };

/** One word for each state. */
export type ConnectionStatus = ConnectionState['status'];

/** What moves the connection from one status to another. */
export type ConnectionEvent =
  | 'connect' // the program asked for it
  | 'established' // registered, socket open and answering, devices and subscriptions restored
  | 'failed' // the link broke or an attempt failed, and another attempt follows
  | 'ended' // nothing more will be tried
  | 'close'; // the program asked for it

const MOVES: Record<ConnectionStatus, Partial<Record<ConnectionEvent, ConnectionStatus>>> = {
  idle: { connect: 'connecting', close: 'closed' },
  connecting: {
    established: 'connected',
    failed: 'reconnecting',
    ended: 'closed',
    close: 'closed',
  },
  connected: { failed: 'reconnecting', ended: 'closed', close: 'closed' },
  reconnecting: {
    established: 'connected',
    failed: 'reconnecting',
    ended: 'closed',
    close: 'closed',
  },
  closed: { connect: 'connecting', close: 'closed' },
};

/** The status after `event`, or `undefined` when the event is not legal in `status`. */
export function next(
  status: ConnectionStatus,
  event: ConnectionEvent,
): ConnectionStatus | undefined {
  return MOVES[status][event];
}
