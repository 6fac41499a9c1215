import { isSameValue } from '@ubii/proto';

/** A mapping as it stands in a mapping file. */
export type WrittenMapping = Readonly<Record<string, unknown>>;

/** A change of one mapping among those of a bridge. */
export type MappingChange =
  | { readonly kind: 'add'; readonly mapping: WrittenMapping; readonly index: number }
  | {
      readonly kind: 'replace';
      readonly before: WrittenMapping;
      readonly mapping: WrittenMapping;
      readonly index: number;
    }
  | { readonly kind: 'remove'; readonly before: WrittenMapping; readonly index: number };

/** A list with a change in it, and where it is. */
export interface ChangedMappings {
  readonly list: readonly WrittenMapping[];
  readonly index: number;
}

/**
 * Makes a change in a list that may be a newer one than that it was made for.
 *
 * @returns `undefined` when the mapping that it changes is not there any more as it was
 */
export function applyChange(
  list: readonly WrittenMapping[],
  change: MappingChange,
): ChangedMappings | undefined {
  if (change.kind === 'add') {
    const index = Math.min(change.index, list.length);
    return { list: list.toSpliced(index, 0, change.mapping), index };
  }
  const index = placeOf(list, change.before, change.index);
  if (index === undefined) return undefined;
  return change.kind === 'remove'
    ? { list: list.toSpliced(index, 1), index }
    : { list: list.with(index, change.mapping), index };
}

/** The change that takes back another one. @param index where that one was made */
export function inverseOf(change: MappingChange, index: number): MappingChange {
  switch (change.kind) {
    case 'add':
      return { kind: 'remove', before: change.mapping, index };
    case 'remove':
      return { kind: 'add', mapping: change.before, index };
    case 'replace':
      return { kind: 'replace', before: change.mapping, mapping: change.before, index };
  }
}

/** What others made of a mapping: another one of its name or at its place; `undefined` when it is gone. */
export function theirsOf(
  list: readonly WrittenMapping[],
  before: WrittenMapping,
): WrittenMapping | undefined {
  const name = nameOf(before);
  return list.find((mapping) => nameOf(mapping) === name);
}

/** Name of a mapping; without one, it is made of both sides, as the bridge does. [BR-1] */
export function nameOf(mapping: WrittenMapping): string {
  const word = (member: string): string => {
    const value = mapping[member];
    return typeof value === 'string' ? value : '';
  };
  return word('name') || `${word('foreign')} ${word('direction')} ${word('topic')}`;
}

export function isEnabled(mapping: WrittenMapping): boolean {
  return mapping['enabled'] !== false;
}

/** The same mapping switched on or off: nothing is written for what is the default. */
export function withEnabled(mapping: WrittenMapping, isOn: boolean): WrittenMapping {
  const { enabled: _, ...rest } = mapping;
  return isOn ? rest : { ...rest, enabled: false };
}

/** A copy with a name that no other mapping has. */
export function copyOf(mapping: WrittenMapping, list: readonly WrittenMapping[]): WrittenMapping {
  const names = new Set(list.map(nameOf));
  const base = `${nameOf(mapping).slice(0, 180)} copy`;
  let name = base;
  for (let number = 2; names.has(name); number++) name = `${base} ${number}`;
  return { ...mapping, name };
}

function placeOf(
  list: readonly WrittenMapping[],
  mapping: WrittenMapping,
  index: number,
): number | undefined {
  if (isSameValue(list[index], mapping)) return index;
  const found = list.findIndex((one) => isSameValue(one, mapping));
  return found < 0 ? undefined : found;
}
