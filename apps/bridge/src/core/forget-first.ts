/** Evicts the first entry of a table that has more than the maximum. @returns the evicted one */
export function forgetFirst<K>(
  table: Pick<Map<K, unknown>, 'size' | 'keys' | 'delete'> | Set<K>,
  most: number,
): K | undefined {
  if (table.size <= most) return undefined;
  for (const key of table.keys()) {
    table.delete(key);
    return key;
  }
  return undefined;
}
