import type { MasterAddress } from '@ubii/proto';
import { isLoopbackHost, phoneAddresses } from '../connect-phone/addresses.ts';

/** Where a program of the user runs. */
export type Place = 'here' | 'elsewhere';

/** Returns whether a page of this address is on the computer of the master. */
export function isOnMaster(pageUrl: string): boolean {
  return isLoopbackHost(new URL(pageUrl).hostname);
}

/**
 * Returns the address with which a program reaches the master; `undefined` when it listens on its own computer only.
 * @param place `here`: on the computer of the master
 */
export function programAddress(
  place: Place,
  addresses: readonly MasterAddress[],
  pageUrl: string,
): string | undefined {
  const { origin } = new URL(pageUrl);
  if (place === 'here' || !isOnMaster(pageUrl)) return origin;
  return phoneAddresses(addresses, pageUrl)[0]?.url;
}

/** Returns whether the library trusts only authorities that it is told of: the master has one of its own. */
export function needsAuthority(address: string): boolean {
  return new URL(address).protocol === 'https:';
}
