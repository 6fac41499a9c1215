import type { MasterAddress } from '@ubii/proto';
import { phoneAddresses } from '../connect-phone/addresses.ts';
import { isThisMachine } from '../join/this-machine.ts';

/** Where a program of the user runs; `here`: on the computer of this page. */
export type Place = 'here' | 'elsewhere';

/** Returns the address with which a program reaches the master; `undefined` when it listens on its own computer only. */
export function programAddress(
  place: Place,
  addresses: readonly MasterAddress[],
  pageUrl: string,
): string | undefined {
  const { origin, hostname } = new URL(pageUrl);
  if (place === 'here' || !isThisMachine(hostname)) return origin;
  return phoneAddresses(addresses, pageUrl)[0]?.url;
}

/** Returns whether programs have to be told whom to trust: the certificate is of an authority of the master. */
export function needsAuthority(address: string): boolean {
  return new URL(address).protocol === 'https:';
}
