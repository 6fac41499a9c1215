import type { JsonRow } from './json-rows.ts';

/** How lines of a value differ from those of the value before. */
export interface RowChanges {
  /** What a line said before, by path; undefined when it is new. */
  readonly was: ReadonlyMap<string, string | undefined>;
  /** Lines that are there no more. */
  readonly gone: readonly JsonRow[];
}

const NONE: RowChanges = { was: new Map(), gone: [] };

/** Compares what is shown: closed branches by what they say of themselves. */
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
