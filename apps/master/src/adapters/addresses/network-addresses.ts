import { existsSync } from 'node:fs';
import { networkInterfaces } from 'node:os';
import type { NetworkInterfaceInfo } from 'node:os';

import { classifyInterface } from './classify-interface.ts';
import type { NetworkKind } from './classify-interface.ts';

/** One address of this machine that others may reach. */
export interface NetworkAddress {
  readonly kind: NetworkKind;
  /** Name of the interface as the system calls it. */
  readonly interfaceName: string;
  /** IPv4 address; an IPv6 address without zone where an interface has nothing else. */
  readonly address: string;
}

/** Folder with properties of network interfaces; Linux only. */
const SYSTEM_FOLDER = '/sys/class/net';

/**
 * The addresses of this machine in its networks, the likeliest for a phone first. The system is
 * asked, nothing is contacted.
 */
export function listNetworkAddresses(
  interfaces: NodeJS.Dict<NetworkInterfaceInfo[]> = networkInterfaces(),
  hasFile: (path: string) => boolean = existsSync,
): readonly NetworkAddress[] {
  const found = Object.entries(interfaces).flatMap(([name, addresses = []]) => {
    const kind = classifyInterface(name, {
      isWireless: hasFile(`${SYSTEM_FOLDER}/${name}/wireless`),
      // A bridge or a tunnel has no hardware behind it.
      hasHardware: hasFile(SYSTEM_FOLDER) ? hasFile(`${SYSTEM_FOLDER}/${name}/device`) : undefined,
    });
    return bestOf(addresses).map((address) => ({ kind, interfaceName: name, address }));
  });
  const order: readonly NetworkKind[] = ['wifi', 'ethernet', 'virtual'];
  return found.sort((a, b) => order.indexOf(a.kind) - order.indexOf(b.kind));
}

/** An interface has one IPv6 address for each of several purposes; people want one they can type. */
function bestOf(addresses: readonly NetworkInterfaceInfo[]): readonly string[] {
  const usable = addresses.filter(
    ({ internal, address }) => !internal && !/^(fe80:|169\.254\.)/i.test(address),
  );
  const ipv4 = usable.filter(({ family }) => family === 'IPv4');
  return (ipv4.length > 0 ? ipv4 : usable.slice(0, 1)).map(({ address }) => address);
}
