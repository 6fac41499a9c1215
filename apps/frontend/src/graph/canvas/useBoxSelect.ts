import { useEventListener } from '@vueuse/core';
import { shallowRef, type ShallowRef } from 'vue';
import type { GraphEditor } from '../editing/graph-editor.ts';
import type { CanvasStage } from './canvas-stage.ts';
import { followPointer, isClick } from './drag/follow-pointer.ts';
import { onPage, thingAt } from './thing-at.ts';
import type { Box } from './stage-view.ts';

/**
 * Selection box with Shift, or with a finger in selection mode. Selects nodes that it touches, and frames that are
 * entirely inside. Escape restores the previous selection. @returns the box, in pixels of the canvas
 */
export function useBoxSelect(
  container: HTMLElement,
  stage: CanvasStage,
  editor: GraphEditor,
): Readonly<ShallowRef<Box | undefined>> {
  const box = shallowRef<Box>();
  let cancel: (() => void) | undefined;

  useEventListener(container, 'pointerdown', (start) => {
    const thing = thingAt(start.target);
    const isByFinger = stage.isSelecting.value && start.pointerType !== 'mouse';
    const isAsked = (start.shiftKey || isByFinger) && start.button === 0;
    if (!isAsked || (thing !== undefined && thing.kind !== 'frame')) return;
    const before = editor.selection.value.nodes;
    cancel?.();
    cancel = followPointer(start, {
      move(event) {
        if (box.value === undefined && isClick(start, event)) return;
        box.value = onPage(container, start, event);
        const from = stage.toCanvas(
          Math.min(start.clientX, event.clientX),
          Math.min(start.clientY, event.clientY),
        );
        const { k } = stage.view.value;
        const area = { ...from, width: box.value.width / k, height: box.value.height / k };
        editor.select([...before, ...touchedBy(area)]);
      },
      drop() {
        if (box.value === undefined && thing !== undefined) toggle(thing.id);
        box.value = undefined;
      },
      cancel() {
        if (box.value !== undefined) editor.select(before);
        box.value = undefined;
      },
    });
  });

  function toggle(id: string): void {
    const { nodes } = editor.selection.value;
    editor.select(nodes.has(id) ? [...nodes].filter((one) => one !== id) : [...nodes, id]);
  }

  function touchedBy(area: Box): string[] {
    const { nodes } = editor.graph.value;
    return stage.boxes().flatMap((node) => {
      const isFrame = nodes.get(node.id)?.kind === 'frame';
      return (isFrame ? isInside(node, area) : isTouching(node, area)) ? [node.id] : [];
    });
  }
  return box;
}

const isTouching = (a: Box, b: Box): boolean =>
  a.x < b.x + b.width && a.x + a.width > b.x && a.y < b.y + b.height && a.y + a.height > b.y;

const isInside = (a: Box, b: Box): boolean =>
  a.x >= b.x && a.y >= b.y && a.x + a.width <= b.x + b.width && a.y + a.height <= b.y + b.height;
