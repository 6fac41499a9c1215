import type { NodeInfo } from '@ubii/proto';
import { computed, shallowRef } from 'vue';
import type { NewNode } from '../new-nodes.ts';

/** A node that runs modules; dropped on a module, it is assigned that module. */
export interface HostItem {
  readonly kind: 'host';
  readonly host: NodeInfo;
}

/** Item being dragged from the palette, and its position on the page, pixels. */
export interface DraggedItem {
  readonly item: NewNode | HostItem;
  readonly label: string;
  readonly clientX: number;
  readonly clientY: number;
}

/** Item being dragged; there is only one pointer that drags. */
export const draggedItem = shallowRef<DraggedItem>();

/** Node that runs modules, while one is being dragged. */
export const draggedHost = computed(() => {
  const item = draggedItem.value?.item;
  return item?.kind === 'host' ? item.host : undefined;
});

/** Pointer movement up to which a press is a click, pixels; fingers are never quite still. */
const CLICK_PX = 5;
const TAP_PX = 10;
/** Time a finger must rest on an item to drag it instead of scrolling the list, milliseconds. */
const REST_MS = 220;

/**
 * Follows a pointer (mouse, pen or finger) from `pointerdown` on an item of the palette. A finger scrolls the list; it
 * drags the item when it moves sideways or has rested on it.
 * @param drop called with the position of the drop
 * @param click called when the item was not dragged
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
  const isTouch = start.pointerType === 'touch';
  const hold = ({ clientX, clientY }: { clientX: number; clientY: number }): void => {
    draggedItem.value = { item, label, clientX, clientY };
  };
  const move = (event: PointerEvent): void => {
    if (event.pointerId !== start.pointerId) return;
    const [dx, dy] = [Math.abs(event.clientX - x), Math.abs(event.clientY - y)];
    const isStill = Math.hypot(dx, dy) < (isTouch ? TAP_PX : CLICK_PX);
    if (draggedItem.value === undefined) {
      if (isStill) return;
      if (isTouch && dy > dx) {
        end();
        return;
      }
    }
    hold(event);
  };
  /** Prevent scrolling during the drag. */
  const scroll = (event: TouchEvent): void => {
    if (draggedItem.value !== undefined && event.cancelable) event.preventDefault();
  };
  const rest = isTouch ? setTimeout(() => hold(start), REST_MS) : undefined;
  const end = (): void => {
    clearTimeout(rest);
    window.removeEventListener('touchmove', scroll);
    window.removeEventListener('pointermove', move);
    window.removeEventListener('pointerup', up);
    window.removeEventListener('pointercancel', end);
    window.removeEventListener('keydown', key, true);
    draggedItem.value = undefined;
  };
  const up = (event: PointerEvent): void => {
    if (event.pointerId !== start.pointerId) return;
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
  window.addEventListener('touchmove', scroll, { passive: false });
  window.addEventListener('pointermove', move);
  window.addEventListener('pointerup', up);
  window.addEventListener('pointercancel', end);
  window.addEventListener('keydown', key, true);
}
