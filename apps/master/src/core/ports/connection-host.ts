import type { CallerFacts } from './caller-facts.ts';
import type { ClientConnection } from './client-connection.ts';
import type { ClientClaim, ConnectionPeer } from './connection-facts.ts';
import type { ConnectionHandle } from './connection-handle.ts';

/** The master, as the adapter of a transport for topic data sees it. No method throws. */
export interface ConnectionHost {
  /**
   * Whether a connection proves by its resume token that it is of a client which came in from this machine. A transport
   * need not find out the user of its program then. [AC-27]
   */
  provesLocalClient(claim: ClientClaim): boolean;
  /**
   * Reason to refuse a connection before it opens, one sentence; undefined: it is allowed. For transports that
   * can answer before there is a connection; `openConnection` refuses the same ones. [AC-27]
   */
  refuseConnection(claim: ClientClaim, caller: CallerFacts): string | undefined;
  /** Most bytes of a message of the client that a connection claims to be of: a transport reads no more. [TD-70] */
  maxMessageBytes(claim: ClientClaim): number;
  /**
   * Takes an open connection.
   *
   * @param caller who opened it, as the transport knows
   * @returns undefined: refused, and already closed with the reason (TD-6, EX-4)
   */
  openConnection(
    claim: ClientClaim,
    connection: ClientConnection,
    caller: CallerFacts,
    peer?: ConnectionPeer,
  ): ConnectionHandle | undefined;
}
