import type { AddressKind } from './address-kind.ts';

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
