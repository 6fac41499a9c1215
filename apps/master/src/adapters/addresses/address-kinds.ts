import { BlockList, isIP } from 'node:net';

import type { AddressKind } from '../../core/ports/index.ts';

const loopback = new BlockList();
loopback.addSubnet('127.0.0.0', 8);
loopback.addAddress('::1', 'ipv6');

/** RFC 1918, RFC 4193, and the link-local blocks of RFC 3927 and RFC 4291. */
const inPrivateNetworks = new BlockList();
inPrivateNetworks.addSubnet('10.0.0.0', 8);
inPrivateNetworks.addSubnet('172.16.0.0', 12);
inPrivateNetworks.addSubnet('192.168.0.0', 16);
inPrivateNetworks.addSubnet('169.254.0.0', 16);
inPrivateNetworks.addSubnet('fc00::', 7, 'ipv6');
inPrivateNetworks.addSubnet('fe80::', 10, 'ipv6');

/** True for a name or address that means this very machine. */
export function isLoopbackHost(host: string): boolean {
  // Asked several times for each request; a list of blocks makes objects for each question.
  if (isIP(host) === 4) return host.startsWith('127.');
  return host === 'localhost' || host.endsWith('.localhost') || isIn(loopback, host);
}

/** True for an address, not a name, of a private network. */
export function isPrivateAddress(host: string): boolean {
  return isIn(inPrivateNetworks, host);
}

/** True for an IPv4 or IPv6 address, without brackets. */
export function isIpAddress(host: string): boolean {
  return isIP(host) !== 0;
}

/** The address of the other end of a connection in its usual form; undefined when the system does not say. */
export function plainAddress(remoteAddress: string | undefined): string | undefined {
  // An IPv6 socket calls IPv4 addresses so, and link-local ones have a zone.
  const address = remoteAddress?.replace(/^::ffff:(?=\d+\.)/i, '').replace(/%.*$/, '');
  return address !== undefined && isIpAddress(address) ? address : undefined;
}

/** Kind of the remote address of a connection; undefined when the system does not report it. */
export function kindOfPeer(remoteAddress: string | undefined): AddressKind | undefined {
  const address = plainAddress(remoteAddress);
  if (address === undefined) return undefined;
  if (isLoopbackHost(address)) return 'loopback';
  return isPrivateAddress(address) ? 'private' : 'public';
}

/**
 * Returns the unit by which wrong codes and connections are counted, presumably one user: an IPv4 address, or the
 * 64-bit prefix of an IPv6 address. [AC-17] [AC-60]
 *
 * @param address in the form of `plainAddress`
 */
export function placeOf(address: string | undefined): string {
  if (address === undefined || isIP(address) !== 6) return address ?? '';
  const [head = '', tail] = address.split('::');
  const groups = head === '' ? [] : head.split(':');
  const missing =
    tail === undefined ? 0 : 8 - groups.length - tail.split(':').filter(Boolean).length;
  return [...groups, ...Array<string>(Math.max(0, missing)).fill('0')].slice(0, 4).join(':');
}

function isIn(list: BlockList, host: string): boolean {
  const version = isIP(host);
  return version !== 0 && list.check(host, version === 6 ? 'ipv6' : 'ipv4');
}
