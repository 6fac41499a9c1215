import type { ConnectionError } from './connection-error.ts';

/** State of the connection between client and master. A terminal `closed` has the reason. */
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
