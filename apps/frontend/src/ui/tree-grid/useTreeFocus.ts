import { computed, nextTick, onUpdated, shallowRef, type ComputedRef, type Ref } from 'vue';
import { isTypeAhead, TypeAhead } from '../keys/type-ahead.ts';
import type { TreeGridRow } from './tree-grid-row.ts';
import { treeKeyOutcome, type TreeKeyOutcome } from './tree-keys.ts';

/** Data and callbacks for focus and keys. */
export interface TreeFocusOptions<R extends TreeGridRow> {
  readonly rows: () => readonly R[];
  readonly selected: () => string | undefined;
  readonly scroller: Readonly<Ref<HTMLElement | null>>;
  /** Height of a row, pixels. */
  readonly sizeOf: (row: R) => number;
  /** Name for type-ahead. */
  readonly nameOf: (row: R) => string;
  readonly isExpanded: (row: R) => boolean | undefined;
  readonly scrollToIndex: (index: number) => void;
  readonly act: (kind: Exclude<TreeKeyOutcome['kind'], 'focus'>, row: R) => void;
  /** Handles keys that the tree does not. */
  readonly handleOtherKey: (event: KeyboardEvent, row: R) => void;
}

/** Moves the focus over virtual rows. The focused row is always rendered. */
export function useTreeFocus<R extends TreeGridRow>(
  options: TreeFocusOptions<R>,
): {
  /** The row that Tab reaches: the last focused, otherwise the selected, otherwise the first. */
  activeIndex: ComputedRef<number>;
  /** Makes a row the one that Tab reaches. */
  visit(key: string): void;
  handleKey(event: KeyboardEvent): void;
  handleFocus(event: FocusEvent): void;
} {
  const { rows, selected, scroller, sizeOf, nameOf, isExpanded, scrollToIndex } = options;
  const typeAhead = new TypeAhead();
  const activeKey = shallowRef<string>();
  const activeIndex = computed(() => {
    const find = (key: string | undefined): number =>
      key === undefined ? -1 : rows().findIndex((row) => row.key === key);
    const index = find(activeKey.value);
    return index === -1 ? Math.max(0, find(selected())) : index;
  });

  const activeElement = (): HTMLElement | null =>
    scroller.value?.querySelector<HTMLElement>('[role="row"][tabindex="0"]') ?? null;

  async function focusRow(index: number): Promise<void> {
    activeKey.value = rows()[index]?.key;
    scrollToIndex(index);
    await nextTick();
    activeElement()?.focus({ preventScroll: true });
  }

  function handleKey(event: KeyboardEvent): void {
    const row = rows()[activeIndex.value];
    if (row === undefined || isOfControl(event)) return;
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const heightPixels = scroller.value?.clientHeight ?? 0;
    const outcome = treeKeyOutcome(event.key, {
      rows: rows(),
      index: activeIndex.value,
      isExpanded,
      pageSize: Math.max(1, Math.floor(heightPixels / sizeOf(row)) - 1),
    });
    if (outcome !== undefined) {
      event.preventDefault();
      if (outcome.kind === 'focus') void focusRow(outcome.index);
      else options.act(outcome.kind, row);
    } else if (isTypeAhead(event)) {
      event.preventDefault(); // Also prevents single-key shortcuts.
      const names = rows().map((one) => nameOf(one).toLowerCase());
      const found = typeAhead.type(event.key, names, activeIndex.value, event.timeStamp);
      if (found !== undefined) void focusRow(found);
    } else options.handleOtherKey(event, row);
  }

  // Sorting moves rows, and browsers remove the focus from an element that is moved.
  let hasFocus = false;
  onUpdated(() => {
    if (hasFocus && document.activeElement === document.body) {
      activeElement()?.focus({ preventScroll: true });
    }
  });

  function handleFocus(event: FocusEvent): void {
    hasFocus = event.type === 'focusin' || (hasFocus && event.relatedTarget === null);
    if (event.type !== 'focusin' || !(event.target instanceof Element)) return;
    const key = event.target.closest<HTMLElement>('[data-key]')?.dataset['key'];
    if (key !== undefined) activeKey.value = key;
  }

  return { activeIndex, visit: (key) => (activeKey.value = key), handleKey, handleFocus };
}

/** Controls inside a row, such as a menu button, handle their own keys. */
function isOfControl({ target }: KeyboardEvent): boolean {
  return target instanceof HTMLElement && target.role !== 'row' && target.tabIndex >= 0;
}
