import { hostname, networkInterfaces } from 'node:os';
import type { NetworkInterfaceInfo } from 'node:os';

/** The name of this machine in local networks; `ubii.local` when its own cannot be one. */
export function localName(host: string = hostname()): string {
  return `${shortName(host) ?? 'ubii'}.local`;
}

/**
 * Names and addresses under which devices may open this machine now: for its certificate. Link-local
 * IPv6 addresses come without their zone, which certificates do not know.
 */
export function listOwnNames(
  host: string = hostname(),
  interfaces: NodeJS.Dict<NetworkInterfaceInfo[]> = networkInterfaces(),
): readonly string[] {
  const short = shortName(host);
  const names = short === undefined ? ['localhost'] : ['localhost', short, `${short}.local`];
  const addresses = Object.values(interfaces).flatMap((all = []) =>
    all.map(({ address }) => address.replace(/%.*$/, '')),
  );
  return [...new Set([...names, '127.0.0.1', '::1', ...addresses])];
}

function shortName(host: string): string | undefined {
  const short = host.split('.')[0]?.toLowerCase() ?? '';
  // Names allowed in certificates: RFC 5280, 4.2.1.6, without underscores.
  return /^[a-z0-9]([a-z0-9-]*[a-z0-9])?$/.test(short) ? short : undefined;
}
