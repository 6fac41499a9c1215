import { useEventListener } from '@vueuse/core';
import { onBeforeUnmount, watch } from 'vue';
import type { CanvasContext } from './useCanvas.ts';
import type { GraphEditor } from '../editing/graph-editor.ts';
import type { Point } from '../model/graph.ts';
import { thingAt } from './thing-at.ts';

const CLICK_PX = 4;

/** Pointer input on the canvas: pressing a node drags it, pressing empty canvas clears the selection. */
export function useCanvasPointers(
  { stage, gesture, drag, points, resize }: CanvasContext,
  editor: GraphEditor,
  askAt: (clientX: number, clientY: number) => void,
): void {
  const { container } = stage;
  let pressed: Point | undefined;

  useEventListener(
    container,
    'pointerdown',
    ({ target, clientX, clientY, shiftKey, ctrlKey, metaKey, pointerType }) => {
      gesture.refusal.value = undefined;
      const isEmpty = thingAt(target) === undefined;
      const isByFinger = stage.isSelecting.value && pointerType !== 'mouse';
      const isAdding = shiftKey || ctrlKey || metaKey || isByFinger;
      pressed = isEmpty && !isAdding && !stage.isPanning ? { x: clientX, y: clientY } : undefined;
    },
    { capture: true },
  );
  useEventListener(container, 'pointerdown', (event) => {
    if (event.button !== 0 || stage.isPanning || gesture.pull.value !== undefined) return;
    // Pointers select text in fields.
    if ((event.target as Element).closest('input, textarea, select')) return;
    const thing = thingAt(event.target);
    if (thing === undefined || thing.kind === 'wire') return;
    // With Shift, a selection box can start on a frame.
    if (thing.kind !== 'frame' || !event.shiftKey) drag.press(event, thing.id);
  });
  useEventListener(container, 'pointerup', ({ clientX, clientY }) => {
    if (pressed && Math.hypot(clientX - pressed.x, clientY - pressed.y) < CLICK_PX)
      editor.select([]);
    pressed = undefined;
  });
  // The middle button pans; prevent the browser's autoscroll.
  useEventListener(container, 'mousedown', (event) => {
    if (event.button === 1) event.preventDefault();
  });
  useEventListener(container, 'dblclick', ({ clientX, clientY, target }) => {
    if (thingAt(target) === undefined) askAt(clientX, clientY);
  });

  watch(editor.graph, () => {
    drag.handleGraph();
    points.handleGraph();
    resize.handleGraph();
  });
  onBeforeUnmount(() => {
    gesture.cancel();
    drag.cancel();
    points.cancel();
    resize.cancel();
  });
}
