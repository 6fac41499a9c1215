import { useEventListener } from '@vueuse/core';
import { nextTick, shallowRef, type Ref, type ShallowRef } from 'vue';

export interface ReorderPorts {
  readonly count: () => number;
  readonly nameOf: (index: number) => string;
  readonly move: (from: number, to: number) => void;
}

/** Reorders rows by dragging their grips, and by arrow keys on them. */
export interface Reorder {
  /** Index of the row that is dragged. */
  readonly dragged: Readonly<ShallowRef<number | undefined>>;
  /** What was moved, for screen readers. */
  readonly announcement: Readonly<ShallowRef<string>>;
  handleKey(event: KeyboardEvent, index: number): void;
  start(event: PointerEvent, index: number): void;
}

const STEPS: Readonly<Record<string, number>> = { ArrowUp: -1, ArrowDown: 1 };

/** @param list has a `data-reorder-row` for each row, with a `data-reorder-grip` in it */
export function useReorder(list: Readonly<Ref<HTMLElement | null>>, ports: ReorderPorts): Reorder {
  const dragged = shallowRef<number>();
  const announcement = shallowRef('');

  function move(from: number, to: number): void {
    const name = ports.nameOf(from);
    ports.move(from, to);
    announcement.value = `${name} is now ${to + 1} of ${ports.count()}.`;
  }
  function indexAt(y: number): number {
    const rows = [...(list.value?.querySelectorAll('[data-reorder-row]') ?? [])];
    const below = rows.findIndex((row) => y < row.getBoundingClientRect().bottom);
    return below === -1 ? rows.length - 1 : below;
  }
  useEventListener(window, 'pointermove', ({ clientY }: PointerEvent) => {
    const from = dragged.value;
    if (from === undefined) return;
    const to = indexAt(clientY);
    if (to === from) return;
    move(from, to);
    dragged.value = to;
  });
  useEventListener(window, ['pointerup', 'pointercancel'], () => (dragged.value = undefined));
  return {
    dragged,
    announcement,
    handleKey(event, index) {
      const to = index + (STEPS[event.key] ?? 0);
      if (to === index || to < 0 || to >= ports.count()) return;
      event.preventDefault();
      move(index, to);
      void nextTick(() =>
        list.value?.querySelectorAll<HTMLElement>('[data-reorder-grip]')[to]?.focus(),
      );
    },
    start(event, index) {
      if (event.button !== 0) return;
      event.preventDefault();
      dragged.value = index;
    },
  };
}
