import type { AddressKind } from './address-kind.ts';

/** Parameters in the URL of a socket. */
export interface ConnectionQuery {
  readonly clientId: string | undefined;
  readonly token: string | undefined;
}

/** The client that opens a socket, as the transport sees it; unknown facts are left out [EX-25]. */
export interface ConnectionPeer {
  /** The header `User-Agent`, of any length. */
  readonly userAgent?: string | undefined;
  readonly addressKind?: AddressKind | undefined;
}
