import type { ListRow } from './list-rows.ts';

/** What a key does in the list, after the treegrid pattern of WAI-ARIA. */
export type ListKeyOutcome =
  | { readonly kind: 'focus'; readonly index: number }
  | { readonly kind: 'fold' | 'open' | 'rename' | 'disconnect'; readonly row: ListRow };

/** @param pageSize rows that fit on the screen · `undefined` for keys that mean nothing here */
export function listKeyOutcome(
  key: string,
  rows: readonly ListRow[],
  index: number,
  pageSize: number,
): ListKeyOutcome | undefined {
  const row = rows[index];
  if (row === undefined) return undefined;
  const focus = (target: number): ListKeyOutcome => ({
    kind: 'focus',
    index: Math.min(rows.length - 1, Math.max(0, target)),
  });
  switch (key) {
    case 'ArrowDown':
      return focus(index + 1);
    case 'ArrowUp':
      return focus(index - 1);
    case 'PageDown':
      return focus(index + pageSize);
    case 'PageUp':
      return focus(index - pageSize);
    case 'Home':
      return focus(0);
    case 'End':
      return focus(rows.length - 1);
    case 'ArrowRight':
      if (row.isExpanded === undefined) return undefined;
      return row.isExpanded ? focus(index + 1) : { kind: 'fold', row };
    case 'ArrowLeft': {
      if (row.isExpanded) return { kind: 'fold', row };
      const parent = rows.findLastIndex((one, at) => at < index && one.level < row.level);
      return row.level === 1 || parent === -1 ? undefined : focus(parent);
    }
    case 'Enter':
    case ' ':
      return { kind: row.kind === 'device' ? 'fold' : 'open', row };
    case 'F2':
      return row.kind === 'client' ? { kind: 'rename', row } : undefined;
    case 'Delete':
      return row.kind === 'client' ? { kind: 'disconnect', row } : undefined;
    default:
      return undefined;
  }
}
