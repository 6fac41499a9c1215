/** Names of one list or graph, sorted; see `sortedNames`. */
export type SortedNames = readonly string[];

/** Sorts names, so that names with the same beginning are adjacent. */
export function sortedNames(names: Iterable<string>): SortedNames {
  return [...new Set(names)].sort((a, b) => (a < b ? -1 : a > b ? 1 : 0));
}

/**
 * Returns the index at which a name starts to differ from the most similar name; undefined when no other name has the
 * same beginning. That part must stay visible when the name is shortened.
 */
export function distinctAt(name: string, names: SortedNames): number | undefined {
  const at = lowerBound(names, name);
  const next = names[at] === name ? at + 1 : at;
  const shared = Math.max(common(name, names[at - 1]), common(name, names[next]));
  return shared === 0 ? undefined : Math.min(shared, Math.max(0, name.length - 1));
}

/** Length of the common prefix of two names. */
function common(name: string, other: string | undefined): number {
  if (other === undefined) return 0;
  let count = 0;
  while (count < name.length && name[count] === other[count]) count += 1;
  return count;
}

function lowerBound(names: SortedNames, name: string): number {
  let [low, high] = [0, names.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (names[middle]! < name) low = middle + 1;
    else high = middle;
  }
  return low;
}
