import type { TreeGridRow } from './tree-grid-row.ts';

/** Effect of a key in a treegrid, after the treegrid pattern of WAI-ARIA. */
export type TreeKeyOutcome =
  | { readonly kind: 'focus'; readonly index: number }
  | { readonly kind: 'expand' | 'collapse' | 'expand-siblings' | 'open' };

/** State of the tree when a key is pressed. */
export interface TreeSituation<R extends TreeGridRow> {
  readonly rows: readonly R[];
  /** Index of the focused row. */
  readonly index: number;
  /** `undefined` for a row without children. */
  readonly isExpanded: (row: R) => boolean | undefined;
  /** Number of rows that fit on the screen. */
  readonly pageSize: number;
}

/** Returns the effect of a key; `undefined` for other keys. */
export function treeKeyOutcome<R extends TreeGridRow>(
  key: string,
  { rows, index, isExpanded, pageSize }: TreeSituation<R>,
): TreeKeyOutcome | undefined {
  const row = rows[index];
  if (row === undefined) return undefined;
  const focus = (target: number): TreeKeyOutcome => ({
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
      if (isExpanded(row) === undefined) return undefined;
      return isExpanded(row) ? focus(index + 1) : { kind: 'expand' };
    case 'ArrowLeft': {
      if (isExpanded(row)) return { kind: 'collapse' };
      const parent = rows.findLastIndex((one, at) => at < index && one.level < row.level);
      return parent === -1 ? undefined : focus(parent);
    }
    case '*':
      return { kind: 'expand-siblings' };
    case 'Enter':
    case ' ':
      return { kind: 'open' };
    default:
      return undefined;
  }
}
