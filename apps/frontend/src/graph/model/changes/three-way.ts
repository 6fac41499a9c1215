import { isSameValue } from '@ubii/proto';

/** Result of a three-way merge of one value. */
export type ThreeWay<T> =
  | { readonly kind: 'same' | 'mine' | 'theirs'; readonly value: T }
  /** Changed by both, in different ways. */
  | { readonly kind: 'conflict'; readonly value: T };

/** Takes the changed value; when both users changed it, keeps the own one. */
export function threeWay<T>(base: T, mine: T, theirs: T): ThreeWay<T> {
  if (isSameValue(mine, theirs)) return { kind: 'same', value: mine };
  if (isSameValue(base, mine)) return { kind: 'theirs', value: theirs };
  if (isSameValue(base, theirs)) return { kind: 'mine', value: mine };
  return { kind: 'conflict', value: mine };
}

/** Merges the members of an object, each separately. */
export function mergeMembers<T extends object>(
  base: T,
  mine: T,
  theirs: T,
  onConflict: (member: keyof T & string, theirs: unknown, mine: unknown) => void,
): T {
  const merged: Record<string, unknown> = {};
  const members = new Set([...Object.keys(mine), ...Object.keys(theirs)]);
  for (const member of members as Set<keyof T & string>) {
    const result = threeWay<unknown>(base[member], mine[member], theirs[member]);
    if (result.kind === 'conflict') onConflict(member, theirs[member], mine[member]);
    if (result.value !== undefined || member in mine) merged[member] = result.value;
  }
  return merged as T;
}

/** Merges the entries of a map, each separately. */
export function mergeEntries<V>(
  base: ReadonlyMap<string, V>,
  mine: ReadonlyMap<string, V>,
  theirs: ReadonlyMap<string, V>,
  onConflict: (key: string, theirs: V | undefined, mine: V | undefined) => void,
): Map<string, V> {
  const merged = new Map<string, V>();
  for (const key of new Set([...mine.keys(), ...theirs.keys()])) {
    const result = threeWay(base.get(key), mine.get(key), theirs.get(key));
    if (result.kind === 'conflict') onConflict(key, theirs.get(key), mine.get(key));
    if (result.value !== undefined) merged.set(key, result.value);
  }
  return merged;
}
