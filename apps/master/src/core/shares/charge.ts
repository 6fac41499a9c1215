import type { Account } from './account.ts';
import type { Resource } from './resources.ts';

/** One of a scarce resource, which one account pays for: others may use it as well. */
export interface Charged {
  payer: Account | undefined;
}

/** Charges this account from now on; undefined: no account, because the object was removed. */
export function charge(charged: Charged, resource: Resource, payer: Account | undefined): void {
  if (charged.payer === payer) return;
  charged.payer?.add(resource, -1);
  payer?.add(resource, 1);
  charged.payer = payer;
}
