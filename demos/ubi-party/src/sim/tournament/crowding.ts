import type { Player } from './room.ts';

type Person = Pick<Player, 'key' | 'awaySinceMs'>;

/**
 * Returns whose place a new client gets where all places are taken: one of the address that has most of them, if that has at
 * least two more than the address of the new client. Of those, first who is away, then the last one. So places are shared
 * out between addresses, and nobody gains by joining again.
 *
 * @param people who have a place, in their order
 * @param asker key of the client that asks
 * @param addresses what clients of one address share, by key; clients without one neither give nor get a place
 * @returns the key of who gives the place; undefined: nobody
 */
export function crowderOf(
  people: readonly Person[],
  asker: string,
  addresses: ReadonlyMap<string, string>,
): string | undefined {
  const own = addresses.get(asker);
  if (own === undefined) return undefined;
  const byAddress = new Map<string, Person[]>();
  for (const person of people) {
    const address = person.key === undefined ? undefined : addresses.get(person.key);
    if (address === undefined) continue;
    byAddress.set(address, [...(byAddress.get(address) ?? []), person]);
  }
  const share = byAddress.get(own)?.length ?? 0;
  const [largest] = [...byAddress.values()].sort((a, b) => b.length - a.length);
  if (largest === undefined || largest.length < share + 2) return undefined;
  const one = largest.find(({ awaySinceMs }) => awaySinceMs !== undefined) ?? largest.at(-1);
  return one?.key;
}
