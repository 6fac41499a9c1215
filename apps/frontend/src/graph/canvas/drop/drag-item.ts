import type { NodeInfo } from '@ubii/proto';
import { computed, shallowRef } from 'vue';
import type { NewNode } from '../new-nodes.ts';

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

/** Pointers that move less than this have clicked, pixels; fingers are never quite still. */
const CLICK_PX = 5;
const TAP_PX = 10;
/** How long a finger rests on an item until it drags it instead of the list, milliseconds. */
const REST_MS = 220;

/**
 * Follows a pointer that went down on an item of the palette; works for mouse, pen and finger. A
 * finger scrolls the list, and drags the item when it moves sideways or has rested on it.
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
  /** What is dragged is not scrolled, too. */
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
