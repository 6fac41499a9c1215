import { MasterAddressKind } from '@ubii/proto';
import type { MasterAddress } from '@ubii/proto';

import type { MasterEndpoints } from '../../core/areas/settings.ts';
import { isLoopbackHost } from '../addresses/address-kinds.ts';
import type { NetworkKind } from '../addresses/classify-interface.ts';
import type { ListeningPorts } from './listeners.ts';
import type { NetworkAddress } from '../addresses/network-addresses.ts';

const KINDS: { readonly [K in NetworkKind]: MasterAddressKind } = {
  wifi: MasterAddressKind.WIFI,
  ethernet: MasterAddressKind.ETHERNET,
  virtual: MasterAddressKind.VIRTUAL,
};

/** Addresses that mean all networks of a machine. */
const WILDCARDS: readonly string[] = ['::', '0.0.0.0'];

/** Addresses of a master, for clients and for display. */
export interface Reachability {
  /** The address for this machine. */
  readonly localUrl: string;
  /** Addresses for others, best first; empty when other computers cannot reach the master. */
  readonly networkAddresses: readonly MasterAddress[];
  readonly endpoints: MasterEndpoints;
}

export interface ReachabilityContext {
  /** Others can use HTTPS. Browsers need nothing of the kind on this machine. @default false */
  readonly isSecure?: boolean;
  /** The only address for others, such as that of a proxy. [SV-13] @default those of the networks */
  readonly publicUrl?: string | undefined;
}

/**
 * @param host what the master listens on
 * @param networks addresses of this machine, best first
 */
export function describeReachability(
  host: string,
  ports: ListeningPorts,
  networks: readonly NetworkAddress[],
  { isSecure = false, publicUrl }: ReachabilityContext = {},
): Reachability {
  const reachable = isLoopbackHost(host)
    ? []
    : networks.filter(({ address }) => WILDCARDS.includes(host) || address === host);
  const networkAddresses =
    publicUrl !== undefined
      ? [{ kind: MasterAddressKind.PUBLIC, interfaceName: '', url: publicUrl }]
      : reachable.map(({ kind, interfaceName, address }) => ({
          kind: KINDS[kind],
          interfaceName,
          url: urlOf(address, ports.main, isSecure ? 'https' : 'http'),
        }));
  const localUrl = urlOf(WILDCARDS.includes(host) ? 'localhost' : host, ports.main);
  const isLocal = isLoopbackHost(host) || WILDCARDS.includes(host);
  // [SV-10]
  const ipv4Of = (wanted: NetworkKind): string =>
    reachable.find(({ kind, address }) => kind === wanted && !address.includes(':'))?.address ?? '';
  return {
    localUrl,
    networkAddresses,
    endpoints: {
      ipEthernet: ipv4Of('ethernet'),
      ipWlan: ipv4Of('wifi'),
      portServices: ports.services,
      portTopicData: ports.topicData,
      portServicesZmq: ports.zeromq?.services ?? 0,
      portTopicDataZmq: ports.zeromq?.topicData ?? 0,
      addresses: [
        ...networkAddresses,
        ...(isLocal
          ? [{ kind: MasterAddressKind.LOOPBACK, interfaceName: '', url: localUrl }]
          : []),
      ],
    },
  };
}

function urlOf(host: string, port: number, scheme: 'http' | 'https' = 'http'): string {
  return `${scheme}://${host.includes(':') ? `[${host}]` : host}:${port}`;
}
