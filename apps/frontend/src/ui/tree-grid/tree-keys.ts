import type { TreeGridRow } from './tree-grid-row.ts';

/** What a key does in a tree grid, after the treegrid pattern of WAI-ARIA. */
export type TreeKeyOutcome =
  | { readonly kind: 'focus'; readonly index: number }
  | { readonly kind: 'expand' | 'collapse' | 'expand-siblings' | 'open' };

/** Where the keys are pressed. */
export interface TreeSituation<R extends TreeGridRow> {
  readonly rows: readonly R[];
  /** The row with the focus. */
  readonly index: number;
  /** `undefined` for a row without children. */
  readonly isExpanded: (row: R) => boolean | undefined;
  /** Rows that fit on the screen. */
  readonly pageSize: number;
}

/** `undefined` for keys that mean nothing here. */
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
