/** Names of one list or graph, sorted; see `sortedNames`. */
export type SortedNames = readonly string[];

/** Names in the order in which names that begin alike stand beside each other. */
export function sortedNames(names: Iterable<string>): SortedNames {
  return [...new Set(names)].sort((a, b) => (a < b ? -1 : a > b ? 1 : 0));
}

/**
 * The index at which a name begins to differ from the name that is most like it; undefined when
 * no other name begins alike. That part has to stay visible when the name is shortened.
 */
export function distinctAt(name: string, names: SortedNames): number | undefined {
  const at = lowerBound(names, name);
  const next = names[at] === name ? at + 1 : at;
  const shared = Math.max(common(name, names[at - 1]), common(name, names[next]));
  return shared === 0 ? undefined : Math.min(shared, Math.max(0, name.length - 1));
}

/** How many characters two names have in common at their beginning. */
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
