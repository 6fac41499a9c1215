import type { ServiceErrorCode } from '@ubii/proto';
import type { ClientConnection } from '../ports/client-connection.ts';
import type { CloseReason } from '../ports/close-reason.ts';

/** The live socket of a client, as the rest of the master uses it. */
export interface ClientSocket {
  readonly connection: ClientConnection;
  /** Sends a frame of topic data as it is. */
  sendFrame(frame: Uint8Array): void;
  /** Sends the client an error, within a rate limit [TD-17]. */
  sendError(code: ServiceErrorCode, message: string): void;
  sendPing(): void;
  /** Serves the queue: sends what can be sent, and closes a socket that takes nothing [TD-32]. */
  handleSweep(): void;
  /** Whether the client takes lists of records [TD-3] [TD-4]. */
  setRecordLists(takes: boolean): void;
  /** Closes it from our side. */
  close(reason: CloseReason, explanation?: string): void;
  /** Another socket took its place [TD-7]. */
  supersede(): void;
}
