import type { JsonRow } from './json-rows.ts';

/** Differences between the lines of two values. */
export interface RowChanges {
  /** Previous text of changed lines, by path; undefined when new. */
  readonly was: ReadonlyMap<string, string | undefined>;
  /** Removed lines. */
  readonly gone: readonly JsonRow[];
}

const NONE: RowChanges = { was: new Map(), gone: [] };

/** Compares the visible lines: collapsed branches by their summary. */
export function changedRows(
  before: readonly JsonRow[] | undefined,
  now: readonly JsonRow[],
): RowChanges {
  if (before === undefined) return NONE;
  const last = new Map(before.map((row) => [row.path, row]));
  const was = new Map<string, string | undefined>();
  for (const { path, text, isOpen } of now) {
    const row = last.get(path);
    last.delete(path);
    if (row === undefined) was.set(path, undefined);
    else if (row.text !== text && !isOpen) was.set(path, row.text);
  }
  return { was, gone: [...last.values()].filter(({ isBranch }) => !isBranch) };
}
