import type { NodeInfo } from '@ubii/proto';
import { computed, shallowRef } from 'vue';
import type { NewNode } from '../canvas/new-nodes.ts';

/** A node that runs modules: dropped on a module it runs that one. */
export interface HostItem {
  readonly kind: 'host';
  readonly host: NodeInfo;
}

/** What is being dragged from the palette, and where it is on the page, pixels. */
export interface DraggedItem {
  readonly item: NewNode | HostItem;
  readonly label: string;
  readonly clientX: number;
  readonly clientY: number;
}

/** One at a time, for one person has one pointer. */
export const draggedItem = shallowRef<DraggedItem>();

/** The node that runs modules, while one is dragged. */
export const draggedHost = computed(() => {
  const item = draggedItem.value?.item;
  return item?.kind === 'host' ? item.host : undefined;
});

/** Pointers that move less than this have clicked, pixels. */
const CLICK_PX = 5;

/**
 * Follows a pointer that went down on an item of the palette; works for mouse, pen and finger.
 * @param drop is told where it was let go
 * @param click is told when it was not dragged at all
 */
export function dragItem(
  start: PointerEvent,
  item: DraggedItem['item'],
  label: string,
  drop: (dragged: DraggedItem) => void,
  click: () => void = () => undefined,
): void {
  if (start.pointerType === 'mouse' && start.button !== 0) return;
  start.preventDefault();
  const { clientX: x, clientY: y } = start;
  const move = ({ clientX, clientY }: PointerEvent): void => {
    const isStill = Math.hypot(clientX - x, clientY - y) < CLICK_PX;
    if (isStill && draggedItem.value === undefined) return;
    draggedItem.value = { item, label, clientX, clientY };
  };
  const end = (): void => {
    window.removeEventListener('pointermove', move);
    window.removeEventListener('pointerup', up);
    window.removeEventListener('pointercancel', end);
    window.removeEventListener('keydown', key, true);
    draggedItem.value = undefined;
  };
  const up = (event: PointerEvent): void => {
    const dragged = draggedItem.value;
    end();
    if (dragged === undefined) click();
    else drop({ ...dragged, clientX: event.clientX, clientY: event.clientY });
  };
  const key = (event: KeyboardEvent): void => {
    if (event.key !== 'Escape') return;
    event.stopPropagation();
    end();
  };
  window.addEventListener('pointermove', move);
  window.addEventListener('pointerup', up);
  window.addEventListener('pointercancel', end);
  window.addEventListener('keydown', key, true);
}
