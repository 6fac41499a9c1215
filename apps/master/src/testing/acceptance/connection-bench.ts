import type { ErrorMessage } from '@ubii/proto';
import type { TimedPing, TimedPong } from '@ubii/proto/wire';
import type {
  CallerFacts,
  ClientClaim,
  CloseReason,
  ConnectionHost,
} from '../../core/ports/index.ts';

/** Message received at the client's end of a connection. */
export type Seen =
  | { readonly kind: 'record'; readonly record: Uint8Array }
  | { readonly kind: 'list'; readonly records: readonly Uint8Array[] }
  | { readonly kind: 'error'; readonly error: ErrorMessage }
  | { readonly kind: 'frame'; readonly frame: Uint8Array }
  | { readonly kind: 'PING' }
  | { readonly kind: 'PONG'; readonly timed?: TimedPong }
  | { readonly kind: 'close'; readonly reason: CloseReason; readonly explanation?: string };

/** The client's end of a connection. What it sends before the connection is open waits. */
export interface ClientEnd {
  /** The next message. */
  next(): Promise<Seen>;
  /** Resolves when the connection ended or never opened: to a client, that is when nothing more will come. */
  ended(): Promise<void>;
  sendTopicData(bytes: Uint8Array): void;
  sendPing(timed?: TimedPing): void;
  sendPong(): void;
  /** Sends a message that is no heartbeat and cannot be topic data. */
  sendNonsense(): void;
  /** Leaves permanently, as far as the transport can say it. */
  leave(): void;
  /** The connection breaks. */
  cut(): void;
  /** Reads nothing until `resume`. */
  pause(): void;
  resume(): void;
}

/** A transport under test, with clients at its other end. */
export interface ConnectionBench {
  /** Opens a connection. */
  dial(claim: ClientClaim): ClientEnd;
  /** The caller facts of every client of the bench. */
  readonly caller: CallerFacts;
  /** What the transport can say. */
  readonly tells: {
    /** Name of the clients' program, if the transport transfers one. */
    readonly program: string | undefined;
    /** The resume token in the claim. */
    readonly token: boolean;
    /** Why the master closes. */
    readonly reason: boolean;
    /** That a client leaves permanently. */
    readonly leaving: boolean;
  };
  /** Gives the system time to transfer. */
  settle(): Promise<void>;
  close(): Promise<void> | void;
}

/** Makes a bench whose connections open at this host. */
export type OpenBench = (host: ConnectionHost) => Promise<ConnectionBench> | ConnectionBench;
