import type { Caller } from '../access/caller.ts';

/** The other end of a connection, as a transport sees it before a byte has come. */
export interface TransportPeer {
  readonly address: string;
  /** The same for all addresses that one person may have: of IPv6, 64 bits. */
  readonly network: string;
  /** It is an address of this machine. */
  readonly isLocal: boolean;
}

/**
 * Kind of a connection: `local`: from this computer; `stranger`: unknown; `known`: from an address with a joined
 * caller; `member`: with a request of a joined caller; `live`: that of a client for its topic data.
 */
export type ConnectionKind = 'local' | 'stranger' | 'known' | 'member' | 'live';

/** Receives the events of a connection. */
interface ConnectionKeeper {
  handleRequest(connection: OpenConnection): void;
  handleCaller(connection: OpenConnection, caller: Caller['kind']): void;
  handleClient(connection: OpenConnection): void;
  handleClose(connection: OpenConnection): void;
}

/** One connection to one of the ports of the master. */
export class OpenConnection {
  readonly peer: TransportPeer;
  /** Monotonic milliseconds. */
  readonly openedMs: number;
  kind: ConnectionKind;
  readonly #keeper: ConnectionKeeper;
  readonly #cut: () => void;

  constructor(made: {
    readonly peer: TransportPeer;
    readonly kind: ConnectionKind;
    readonly openedMs: number;
    readonly cut: () => void;
    readonly keeper: ConnectionKeeper;
  }) {
    this.peer = made.peer;
    this.kind = made.kind;
    this.openedMs = made.openedMs;
    this.#cut = made.cut;
    this.#keeper = made.keeper;
  }

  /** A request has begun. */
  handleRequest(): void {
    this.#keeper.handleRequest(this);
  }

  /** A request identified its caller. */
  handleCaller(caller: Caller['kind']): void {
    this.#keeper.handleCaller(this, caller);
  }

  /** It carries the topic data of a client from now on. */
  handleClient(): void {
    this.#keeper.handleClient(this);
  }

  /** The transport closed it. May be called more than once. */
  handleClose(): void {
    this.#keeper.handleClose(this);
  }

  /** Closes it at once. */
  end(): void {
    this.handleClose();
    this.#cut();
  }
}
