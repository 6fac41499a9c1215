import type { Authenticator, NodeConnectionOptions } from '@nats-io/transport-node';

import type { ClusterAddress } from '../config/cluster-address.ts';

/** Where a master finds its cluster, and what it calls itself there. */
export interface NatsSettings {
  readonly address: ClusterAddress;
  readonly authenticator: Authenticator | undefined;
  /** Certificates that those of the servers are checked with, PEM. Default: those of the system */
  readonly authorities: string | undefined;
  /** Name that the servers show for this connection. */
  readonly clientName: string;
}

/** A server that does not finish its greeting in this time counts as away, milliseconds. */
const CONNECT_MS = 3_000;
/**
 * A dead line is noticed within `PING_MS * (MAX_PINGS_OUT + 1)`: before other masters take over what a cut-off master
 * owns.
 */
const PING_MS = 1_000;
const MAX_PINGS_OUT = 2;

/** Options of the library: it never gives up, and never shows a message to its own sender. */
export function connectOptions(
  { address, authenticator, authorities, clientName }: NatsSettings,
  reconnectDelayMs: () => number,
): NodeConnectionOptions {
  const isEncrypted = address.isEncrypted || authorities !== undefined;
  return {
    servers: address.servers.map((server) => server.replace(/^\w+:\/\//, '')),
    name: clientName,
    noEcho: true,
    maxReconnectAttempts: -1,
    ignoreAuthErrorAbort: true,
    reconnectDelayHandler: reconnectDelayMs,
    timeout: CONNECT_MS,
    pingInterval: PING_MS,
    maxPingOut: MAX_PINGS_OUT,
    noAsyncTraces: true,
    ...(authenticator && { authenticator }),
    ...(isEncrypted && { tls: authorities === undefined ? {} : { ca: authorities } }),
  };
}
