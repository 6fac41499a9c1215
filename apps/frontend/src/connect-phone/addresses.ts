import { MasterAddressKind, type MasterAddress } from '@ubii/proto';

/** An address as a person types it: host and port apart, so that a long one breaks there. */
export interface AddressParts {
  readonly host: string;
  /** With its colon; empty for the scheme's own port. */
  readonly port: string;
}

export function addressParts(url: string): AddressParts {
  const { protocol, hostname, port } = new URL(url);
  const scheme = protocol === 'http:' ? '' : `${protocol}//`;
  return { host: `${scheme}${hostname}`, port: port === '' ? '' : `:${port}` };
}

/** Addresses another machine can use, best first as the master sorted them. */
export function reachableAddresses(addresses: readonly MasterAddress[]): MasterAddress[] {
  return addresses.filter(({ kind }) => kind !== MasterAddressKind.LOOPBACK);
}

/** The best address for another machine; `undefined` when the master listens on loopback only. */
export function bestAddress(addresses: readonly MasterAddress[]): string | undefined {
  return reachableAddresses(addresses)[0]?.url;
}

/** What kind of network an address belongs to, in people's words. */
export function networkWord(kind: MasterAddress['kind']): string {
  switch (kind) {
    case MasterAddressKind.WIFI:
      return 'Wi-Fi';
    case MasterAddressKind.ETHERNET:
      return 'Ethernet';
    case MasterAddressKind.LOOPBACK:
      return 'This machine only';
    default:
      return 'Virtual';
  }
}

/** The address of a page on the master. */
export function pageAddress(origin: string, path: string): string {
  return new URL(path, origin).href;
}

/** What can be offered to a phone. */
export interface PhoneAddress {
  readonly url: string;
  readonly network: string;
  /** The network interface, as the system calls it; empty when unknown. */
  readonly interfaceName: string;
}

const isLoopbackHost = (hostname: string): boolean =>
  hostname === 'localhost' || hostname === '[::1]' || /^127\./.test(hostname);

/**
 * The addresses for a phone, best first. When the master names none but this page was opened over
 * the network, its own address works for others too.
 */
export function phoneAddresses(
  addresses: readonly MasterAddress[],
  pageUrl: string,
): PhoneAddress[] {
  const reachable = reachableAddresses(addresses).map(({ url, kind, interfaceName }) => ({
    url,
    network: networkWord(kind),
    interfaceName,
  }));
  if (reachable.length > 0) return reachable;
  const { origin, hostname } = new URL(pageUrl);
  if (isLoopbackHost(hostname)) return [];
  return [{ url: origin, network: 'This page’s address', interfaceName: '' }];
}
