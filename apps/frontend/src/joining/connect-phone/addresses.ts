import { MasterAddressKind, type MasterAddress } from '@ubii/proto';
import { JOIN_PATH } from '../../locations/join-location.ts';

/** An address as users type it: host and port separately, so that a long one breaks there. */
export interface AddressParts {
  readonly host: string;
  /** With a leading colon; empty for the scheme's default port. */
  readonly port: string;
}

export function addressParts(url: string): AddressParts {
  const { protocol, hostname, port } = new URL(url);
  const scheme = protocol === 'http:' ? '' : `${protocol}//`;
  return { host: `${scheme}${hostname}`, port: port === '' ? '' : `:${port}` };
}

/** Addresses that another computer can use, best first as sorted by the master. */
export function reachableAddresses(addresses: readonly MasterAddress[]): MasterAddress[] {
  return addresses.filter(({ kind }) => kind !== MasterAddressKind.LOOPBACK);
}

/** The best address for another computer; `undefined` when the master listens on loopback only. */
export function bestAddress(addresses: readonly MasterAddress[]): string | undefined {
  return reachableAddresses(addresses)[0]?.url;
}

/** Kinds of virtual network interfaces, by their usual names. */
const VIRTUAL_KINDS = [
  [/^(utun|tun|tap|wg|tailscale|zt|ham|ppp|ipsec)/i, 'VPN'],
  [/^(docker|br-|veth|podman|cni|flannel|cali|lxc|lxd)/i, 'Container'],
  [/^(virbr|vmnet|vboxnet|vEthernet|bridge)/i, 'Virtual machine'],
] as const;

const LINK_LOCAL = /^(169\.254\.|\[fe[89ab])/i;

/** Returns the kind of network that an address belongs to. */
export function networkWord({ kind, interfaceName, url }: MasterAddress): string {
  if (LINK_LOCAL.test(new URL(url).hostname)) return 'Link-local';
  switch (kind) {
    case MasterAddressKind.WIFI:
      return 'Wi-Fi';
    case MasterAddressKind.ETHERNET:
      return 'Ethernet';
    case MasterAddressKind.LOOPBACK:
      return 'This computer only';
    case MasterAddressKind.PUBLIC:
      return 'Public address';
    default:
      return VIRTUAL_KINDS.find(([pattern]) => pattern.test(interfaceName))?.[1] ?? 'Virtual';
  }
}

/** Returns the URL for joining with a token. Browsers do not send the part after # to servers. [AC-11] */
export function joinAddress(origin: string, token: string): string {
  return `${pageAddress(origin, JOIN_PATH)}#${token}`;
}

/** URL of a page on the master. */
export function pageAddress(origin: string, path: string): string {
  return new URL(path, origin).href;
}

/** An address that can be shown to a phone. */
export interface PhoneAddress {
  readonly url: string;
  readonly network: string;
  /** Name of the network interface; empty when unknown. */
  readonly interfaceName: string;
}

const isLoopbackHost = (hostname: string): boolean =>
  hostname === 'localhost' || hostname === '[::1]' || /^127\./.test(hostname);

/**
 * Addresses for a phone, best first. When the master reports none but this page was opened over the network, its own
 * address works for others, too.
 */
export function phoneAddresses(
  addresses: readonly MasterAddress[],
  pageUrl: string,
): PhoneAddress[] {
  const reachable = reachableAddresses(addresses)
    .map((address) => ({
      url: address.url,
      network: networkWord(address),
      interfaceName: address.interfaceName,
    }))
    // Link-local addresses work only within the same network segment.
    .sort((a, b) => Number(a.network === 'Link-local') - Number(b.network === 'Link-local'));
  if (reachable.length > 0) return reachable;
  const { origin, hostname } = new URL(pageUrl);
  if (isLoopbackHost(hostname)) return [];
  return [{ url: origin, network: 'This page’s address', interfaceName: '' }];
}
