import { ConfigError } from '@ubii/program';
import type { Cancel } from '@ubii/timing';

import { isLoopbackHost } from '../addresses/address-kinds.ts';
import type { ClusterAddress } from '../config/cluster-address.ts';
import type { NatsLink } from './nats-link.ts';

/** Meaning of what is missing: programs that read and write at NATS can do all that a master can. [CU-56] */
const CAN_BE_MASTER = 'can act as a master, and as any client of the cluster';
const ACCEPT =
  'In a network that only the machines of the cluster can reach, --cluster-insecure accepts that.';

/** How a NATS server is used. */
interface Exposure {
  readonly address: Pick<ClusterAddress, 'servers' | 'isEncrypted'>;
  readonly authorities: string | undefined;
  /** The operator takes servers that programs of other machines can use. */
  readonly isAccepted: boolean;
}

/**
 * Refuses to send a login and all that masters say over a network in the clear. To be called before NATS is reached. [CU-64]
 *
 * @throws ConfigError unless the operator accepts that
 */
export function requireTls({ address, authorities, isAccepted }: Exposure): void {
  if (isAccepted || address.isEncrypted || authorities !== undefined) return;
  const exposed = address.servers.filter((server) => !isLoopbackHost(hostOf(server)));
  if (exposed.length > 0) throw new ConfigError(`${unencrypted(exposed.join(', '))} ${ACCEPT}`);
}

/**
 * Refuses a NATS server that programs of other machines can use without a login, and warns about what is accepted, also
 * when another server is used later. [CU-64]
 *
 * @throws ConfigError unless the operator accepts such a server
 */
export function watchExposure(link: NatsLink, exposure: Exposure): Cancel {
  const open = openness(link);
  if (open?.isForOthers === true && !exposure.isAccepted) {
    throw new ConfigError(`${open.text} ${ACCEPT}`);
  }
  const warn = (): void => {
    const text = openness(link)?.text;
    if (text !== undefined) link.log.warn(text);
    const server = link.connection.getServer();
    const isEncrypted = exposure.address.isEncrypted || exposure.authorities !== undefined;
    if (!isEncrypted && !isLoopbackHost(hostOf(server))) link.log.warn(unencrypted(server));
  };
  warn();
  return link.onReach((isConnected) => {
    if (isConnected) warn();
  });
}

/** Who can use the connected server without a login, in words; undefined: none can. */
function openness({
  connection,
}: NatsLink): { readonly text: string; readonly isForOthers: boolean } | undefined {
  const { info } = connection;
  if (info === undefined || info.auth_required === true) return undefined;
  const server = connection.getServer();
  const isForOthers = ![hostOf(server), info.host].every(isLoopbackHost);
  const remedy = 'Give NATS a login, as deploy/nats.conf does';
  const text = isForOthers
    ? `NATS at ${server} admits programs of other machines without a login: each of them ${CAN_BE_MASTER}. ${remedy}, or have it listen on this machine alone (nats-server -a 127.0.0.1).`
    : `NATS at ${server} admits programs of this machine without a login: each of them, of any user, ${CAN_BE_MASTER}. ${remedy}.`;
  return { text, isForOthers };
}

function unencrypted(where: string): string {
  return `NATS at ${where} is used without TLS: a program that can read or change the traffic ${CAN_BE_MASTER}. Use tls:// in --cluster, and --cluster-ca for an authority of your own.`;
}

/** @param server `nats://host:port`, `tls://host:port` or `host:port` */
function hostOf(server: string): string {
  const url = server.includes('://') ? server : `nats://${server}`;
  return new URL(url).hostname.replace(/^\[(.*)\]$/, '$1');
}
