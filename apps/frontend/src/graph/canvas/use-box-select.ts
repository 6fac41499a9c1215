import { useEventListener } from '@vueuse/core';
import { shallowRef, type ShallowRef } from 'vue';
import type { GraphEditor } from '../editor/graph-editor.ts';
import type { CanvasStage } from './canvas-stage.ts';
import type { Box } from './stage-view.ts';

/** Draws a box with Shift held down, and selects what it touches. @returns the box, in pixels of the canvas */
export function useBoxSelect(
  container: HTMLElement,
  stage: CanvasStage,
  editor: GraphEditor,
): Readonly<ShallowRef<Box | undefined>> {
  const box = shallowRef<Box>();
  useEventListener(container, 'pointerdown', (start) => {
    if (!start.shiftKey || start.button !== 0) return;
    if ((start.target as Element).closest('[data-graph-node], [data-wire], [data-wire-chip]'))
      return;
    const before = new Set(editor.selection.value.nodes);
    const { left, top } = container.getBoundingClientRect();
    const move = (event: PointerEvent): void => {
      const x = Math.min(start.clientX, event.clientX);
      const y = Math.min(start.clientY, event.clientY);
      const width = Math.abs(event.clientX - start.clientX);
      const height = Math.abs(event.clientY - start.clientY);
      box.value = { x: x - left, y: y - top, width, height };
      const from = stage.toCanvas(x, y);
      const to = stage.toCanvas(x + width, y + height);
      const touched = [...stage.positions].filter(([id, at]) => {
        const size = stage.sizes.get(id) ?? { width: 0, height: 0 };
        return (
          at.x < to.x && at.x + size.width > from.x && at.y < to.y && at.y + size.height > from.y
        );
      });
      editor.select([...before, ...touched.map(([id]) => id)]);
    };
    const end = (): void => {
      box.value = undefined;
      window.removeEventListener('pointermove', move);
      window.removeEventListener('pointerup', end);
    };
    window.addEventListener('pointermove', move);
    window.addEventListener('pointerup', end);
  });
  return box;
}
