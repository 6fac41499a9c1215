import type { TopicNode } from './topic-node.ts';

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

/** A pause this long begins a new word, milliseconds. */
const WORD_MS = 700;

/** Finds rows by typing the beginning of their names. */
export class TypeAhead {
  #word = '';
  #typedMs = -Infinity;

  /**
   * @param names of the rows, in lower case
   * @param index the row with the focus
   * @param nowMs any clock
   * @returns the row to go to; `undefined` when none begins like that
   */
  type(key: string, names: readonly string[], index: number, nowMs: number): number | undefined {
    const letter = key.toLowerCase();
    const isNewWord = nowMs - this.#typedMs > WORD_MS;
    this.#typedMs = nowMs;
    // The same letter again goes on to the next row, as in every list.
    const isRepeated = !isNewWord && this.#word === letter;
    this.#word = isNewWord || isRepeated ? letter : this.#word + letter;
    const from = isNewWord || isRepeated ? index + 1 : index;
    for (let i = 0; i < names.length; i++) {
      const at = (from + i) % names.length;
      if (names[at]!.startsWith(this.#word)) return at;
    }
    return undefined;
  }
}
