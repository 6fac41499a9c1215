import { fillMaxOf, type Shortage } from '../shares/shortage.ts';
import type { Client } from './client.ts';

/**
 * Clients that are away and use what is short [AC-84]: those first that never had a socket, then the one that is
 * away longest. Never those of a class that may use more than the account that asks.
 */
export function leastMissed(
  clients: Iterable<Client>,
  { account, resource, level }: Shortage,
): Client[] {
  const fillMax = fillMaxOf(account, resource);
  return [...clients]
    .filter(
      (client) =>
        client.status === 'unavailable' &&
        client.account.used(resource) > 0 &&
        client.account.isWithin(level) &&
        fillMaxOf(client.account, resource) <= fillMax,
    )
    .sort(compareMissed);
}

function compareMissed(a: Client, b: Client): number {
  const hadSocket = Number(a.heardSequence !== undefined);
  const hadOtherSocket = Number(b.heardSequence !== undefined);
  return hadSocket - hadOtherSocket || a.statusSinceMs - b.statusSinceMs;
}
