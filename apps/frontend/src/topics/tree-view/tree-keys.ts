import type { TopicNode } from '../tree/topic-node.ts';

/** What a key does in the tree, after the treegrid pattern of WAI-ARIA. */
export type KeyOutcome =
  | { readonly kind: 'focus'; readonly index: number }
  | { readonly kind: 'expand' | 'collapse'; readonly node: TopicNode }
  | { readonly kind: 'expand-siblings'; readonly node: TopicNode }
  | { readonly kind: 'select'; readonly node: TopicNode };

/** Where the keys are pressed. */
export interface TreeSituation {
  readonly rows: readonly TopicNode[];
  /** The row with the focus. */
  readonly index: number;
  readonly isExpanded: (node: TopicNode) => boolean;
  /** Rows that fit on the screen. */
  readonly pageSize: number;
}

/** `undefined` for keys that mean nothing here. */
export function keyOutcome(key: string, situation: TreeSituation): KeyOutcome | undefined {
  const { rows, index, isExpanded, pageSize } = situation;
  const node = rows[index];
  if (node === undefined) return undefined;
  const focus = (target: number): KeyOutcome => ({
    kind: 'focus',
    index: Math.min(rows.length - 1, Math.max(0, target)),
  });
  const isOpen = node.isBranch && isExpanded(node);
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
      if (!node.isBranch) return undefined;
      return isOpen ? focus(index + 1) : { kind: 'expand', node };
    case 'ArrowLeft':
      if (isOpen) return { kind: 'collapse', node };
      return node.parent && node.level > 1 ? focus(rows.indexOf(node.parent)) : undefined;
    case '*':
      return { kind: 'expand-siblings', node };
    case 'Enter':
    case ' ':
      if (node.rate) return { kind: 'select', node };
      return { kind: isOpen ? 'collapse' : 'expand', node };
    default:
      return undefined;
  }
}
