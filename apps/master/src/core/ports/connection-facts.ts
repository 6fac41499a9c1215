import type { AddressKind } from './address-kind.ts';

/** The client that a connection says it is of, with its proof. */
export interface ClientClaim {
  readonly clientId: string | undefined;
  /** Resume token of the client [EX-4]. */
  readonly token: string | undefined;
  /** When the client sent it, by the client's clock; left out when it does not say [EX-51]. */
  readonly sentMs?: number | undefined;
}

/** The program at the other end of a connection, as the transport sees it; unknown facts are left out [EX-25]. */
export interface ConnectionPeer {
  /** Name of the program as it tells the transport, of any length. */
  readonly program?: string | undefined;
  readonly addressKind?: AddressKind | undefined;
}
