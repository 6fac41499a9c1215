import { announceMaster } from '@ubii/discovery';
import type { AnnouncedMaster } from '@ubii/discovery';
import { MasterAddressKind } from '@ubii/proto';

import type { Log } from '../../core/ports/index.ts';
import type { ListeningPorts } from '../network/listeners.ts';
import type { Reachability } from '../network/reachability.ts';

export interface AnnounceContext {
  readonly id: string;
  readonly name: string;
  readonly version: string;
  readonly ports: ListeningPorts;
  /** HTTPS is there as well as HTTP. */
  readonly https: boolean;
  /** Name of this machine in the local network, such as `workshop.local`. */
  readonly host: string;
  readonly reachability: () => Reachability;
  readonly log: Log;
}

/** Announces the master where others can reach it, until it is closed. [DI-1] */
export function announce(context: AnnounceContext): AnnouncedMaster {
  const { id, name, version, ports, https, host, reachability, log } = context;
  return announceMaster({
    announcement: {
      id,
      name,
      version,
      https,
      port: ports.main,
      servicesPort: ports.services,
      topicDataPort: ports.topicData,
    },
    host,
    addresses: () => announcedAddresses(reachability()),
    onName: (instance) => log.info('announced in the local network', { name: instance }),
    onProblem: (reason) =>
      log.warn('cannot announce the master in the local network: clients need its address', {
        reason,
      }),
  });
}

/** IPv4 addresses of physical networks. Containers and tunnels are left out. */
export function announcedAddresses({ networkAddresses }: Reachability): readonly string[] {
  return networkAddresses
    .filter(({ kind }) => kind !== MasterAddressKind.VIRTUAL)
    .map(({ url }) => new URL(url).hostname)
    .filter((host) => !host.includes(':'));
}
