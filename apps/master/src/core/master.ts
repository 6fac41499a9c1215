import type { Init, ServiceReply, ServiceRequest } from '@ubii/proto';
import type { Role } from './access/roles.ts';
export type { Role } from './access/roles.ts';
import type { AddressKind } from './ports/address-kind.ts';
import type { CallerFacts } from './ports/caller-facts.ts';
import type { ClientConnection } from './ports/client-connection.ts';
import type { ConnectionHandle } from './ports/connection-handle.ts';

/** The reply to one service request. */
export interface ServiceAnswer {
  readonly reply: Init<ServiceReply>;
  /** To be called once, when the reply was handed to the transport: what must not overtake the reply follows (TD-24). Never throws. */
  afterReply(): void;
}

/** What a terminal shows, so that somebody can join. */
export interface TerminalJoin {
  readonly token: string;
  readonly code: string;
  /** Epoch milliseconds. */
  readonly expiresMs: number;
}

/** What a client put into the URL of its socket. */
export interface ConnectionQuery {
  readonly clientId: string | undefined;
  readonly token: string | undefined;
}

/** Who opens a socket, as the transport sees it; what it cannot tell is left out [EX-25]. */
export interface ConnectionPeer {
  /** The header `User-Agent`, of any length. */
  readonly userAgent?: string | undefined;
  readonly addressKind?: AddressKind | undefined;
}

/** One measured quantity with its values, fit for Prometheus. Labels come from closed lists. */
export interface MetricFamily {
  /** snake_case with unit, such as `ubii_records_received_total`. */
  readonly name: string;
  readonly help: string;
  readonly kind: 'counter' | 'gauge';
  /** Every value has the same label names. A family without labels has one value. */
  readonly values: readonly {
    readonly labels: Readonly<Record<string, string>>;
    readonly value: number;
  }[];
}

/** Every metric of the master at one moment. */
export type MasterMetrics = readonly MetricFamily[];

/** A master without transports: feed it requests and connections. Nothing a client sends makes a method throw or reject. */
export interface Master {
  /** Id of this run, a UUID: what `server_configuration` and `master_status` show. */
  readonly id: string;
  /** Answers one decoded request; errors are in the reply. Settles within `limits.serviceTimeoutMs`. */
  handleServiceRequest(request: ServiceRequest, caller: CallerFacts): Promise<ServiceAnswer>;
  /** The reply to a request the edge refused itself: undecodable (pass the `DecodeError`), or with a `ServiceError` of its choice. Counts it (SV-7). */
  refuseServiceRequest(cause: unknown): ServiceAnswer;
  /** Why whoever asks for a pipe is not to be given one, before it is open; undefined: it is. [AC-27] */
  refuseConnection(query: ConnectionQuery, caller: CallerFacts): string | undefined;
  /** Takes an open pipe. `undefined`: refused, and already closed with the code that says why (TD-6, EX-4). */
  openConnection(
    query: ConnectionQuery,
    connection: ClientConnection,
    caller: CallerFacts,
    peer?: ConnectionPeer,
  ): ConnectionHandle | undefined;
  readonly metrics: () => MasterMetrics;
  /** What this caller may do: for what the edge shows by itself. */
  roleOf(caller: CallerFacts): Role;
  /** Makes the leave to join for the terminal of this run, in place of that of the run before [AC-19]. */
  openTerminal(): Promise<TerminalJoin>;
  /** Ends every timer, closes every connection with code 1001, and ends modules and workers. */
  close(): Promise<void>;
}
