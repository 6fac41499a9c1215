/** Makes room in a table that is to have at most so many entries. @returns the entry that came first, when it had to go */
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
