import { useElementSize } from '@vueuse/core';
import { computed, nextTick, onUpdated, shallowRef, type ComputedRef, type Ref } from 'vue';
import type { TopicTreeView } from './useTopicTree.ts';
import type { TopicNode } from '../tree/topic-node.ts';
import { isTypeAhead, TypeAhead } from '../../ui/keys/type-ahead.ts';
import { keyOutcome } from './tree-keys.ts';

/** What the keys of the tree need from it. */
export interface TreeFocusOptions {
  readonly view: TopicTreeView;
  readonly selected: () => string | undefined;
  readonly scroller: Readonly<Ref<HTMLElement | null>>;
  /** Pixels. */
  readonly rowHeight: Readonly<Ref<number>>;
  readonly scrollToIndex: (index: number) => void;
  readonly choose: (node: TopicNode) => void;
}

/** Moves the focus over rows of which only a few are drawn. The row with the focus always is one of them. */
export function useTreeFocus(options: TreeFocusOptions): {
  /** The row that Tab reaches: the one last visited, or the selected one, or the first. */
  activeIndex: ComputedRef<number>;
  /** Makes a row the one that Tab reaches. */
  visit(node: TopicNode): void;
  handleKey(event: KeyboardEvent): void;
  handleFocus(event: FocusEvent): void;
} {
  const { view, selected, scroller, rowHeight, scrollToIndex, choose } = options;
  const { rows, model } = view;
  const { height } = useElementSize(scroller);
  const typeAhead = new TypeAhead();
  const activeKey = shallowRef<string>();
  const activeIndex = computed(() => {
    const find = (key: string | undefined): number =>
      key === undefined ? -1 : rows.value.findIndex((node) => node.key === key);
    const index = find(activeKey.value);
    return index === -1 ? Math.max(0, find(selected())) : index;
  });

  const activeElement = (): HTMLElement | null =>
    scroller.value?.querySelector<HTMLElement>('[role="row"][tabindex="0"]') ?? null;

  async function focusRow(index: number): Promise<void> {
    activeKey.value = rows.value[index]?.key;
    scrollToIndex(index);
    await nextTick();
    activeElement()?.focus({ preventScroll: true });
  }

  function handleKey(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const outcome = keyOutcome(event.key, {
      rows: rows.value,
      index: activeIndex.value,
      isExpanded: (node) => model.isExpanded(node),
      pageSize: Math.max(1, Math.floor(height.value / rowHeight.value) - 1),
    });
    if (outcome !== undefined) {
      event.preventDefault();
      if (outcome.kind === 'focus') void focusRow(outcome.index);
      else if (outcome.kind === 'select') choose(outcome.node);
      else if (outcome.kind === 'expand-siblings') view.expandSiblings(outcome.node);
      else view.setExpanded(outcome.node, outcome.kind === 'expand');
    } else if (isTypeAhead(event)) {
      event.preventDefault(); // also keeps the letter from the program's own shortcuts
      const names = rows.value.map((node) => view.nameOf(node).toLowerCase());
      const found = typeAhead.type(event.key, names, activeIndex.value, event.timeStamp);
      if (found !== undefined) void focusRow(found);
    }
  }

  // A ranking moves rows, and a browser takes the focus from an element that is moved.
  let hasFocus = false;
  onUpdated(() => {
    if (hasFocus && document.activeElement === document.body) {
      activeElement()?.focus({ preventScroll: true });
    }
  });

  return {
    activeIndex,
    visit: (node) => (activeKey.value = node.key),
    handleKey,
    handleFocus: (event) => {
      hasFocus = event.type === 'focusin' || (hasFocus && event.relatedTarget === null);
    },
  };
}
