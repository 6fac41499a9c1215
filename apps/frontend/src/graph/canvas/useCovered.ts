import { watch } from 'vue';
import type { Size } from '../model/graph.ts';
import type { CanvasStage } from './canvas-stage.ts';
import { coveredView } from './covered-view.ts';
import type { View } from './stage-view.ts';

/**
 * Keeps what is seen in view while the lower part of the canvas is covered, and returns to the view before, unless the
 * user has moved the canvas meanwhile.
 * @param covered height, pixels
 */
export function useCovered(stage: CanvasStage, covered: () => number): void {
  /** View and size before, and the view that took its place. */
  let before: { readonly view: View; readonly viewport: Size; shown?: View } | undefined;
  watch(covered, async (height, old) => {
    if (old === 0) before = { view: stage.view.value, viewport: stage.viewport.value };
    const given = before;
    if (given === undefined) return;
    if (given.shown !== undefined && !isSame(stage.view.value, given.shown)) {
      before = undefined;
      return;
    }
    const { view, viewport } = given;
    if (height === 0) before = undefined;
    const next = height === 0 ? view : coveredView(view, stage.boxes(), viewport, height);
    given.shown = next;
    await stage.look(next);
  });
}

const isSame = (a: View, b: View): boolean =>
  Math.abs(a.x - b.x) < 1 && Math.abs(a.y - b.y) < 1 && Math.abs(a.k - b.k) < 0.001;
