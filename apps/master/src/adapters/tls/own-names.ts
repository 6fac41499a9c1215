import { hostname, networkInterfaces } from 'node:os';
import type { NetworkInterfaceInfo } from 'node:os';

/**
 * Names and addresses under which devices may open this machine now: for its certificate. Link-local
 * IPv6 addresses come without their zone, which certificates do not know.
 */
export function listOwnNames(
  host: string = hostname(),
  interfaces: NodeJS.Dict<NetworkInterfaceInfo[]> = networkInterfaces(),
): readonly string[] {
  const short = host.split('.')[0]?.toLowerCase() ?? '';
  // What certificates may say: RFC 5280, 4.2.1.6, and no underscore.
  const names = /^[a-z0-9]([a-z0-9-]*[a-z0-9])?$/.test(short)
    ? ['localhost', short, `${short}.local`]
    : ['localhost'];
  const addresses = Object.values(interfaces).flatMap((all = []) =>
    all.map(({ address }) => address.replace(/%.*$/, '')),
  );
  return [...new Set([...names, '127.0.0.1', '::1', ...addresses])];
}
