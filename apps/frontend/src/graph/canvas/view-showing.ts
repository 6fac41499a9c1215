import type { Size } from '../model/graph.ts';
import type { View } from './stage-view.ts';

/** Margins around a box that is brought into view, pixels; docks cover top and bottom. */
const MARGIN = { left: 24, top: 60, right: 24, bottom: 72 };

/**
 * Returns the view after the smallest pan that shows a box of the canvas; undefined when it is visible. Of a box larger
 * than the viewport, the beginning is shown.
 */
export function viewShowing(
  view: View,
  viewport: Size,
  box: { readonly x: number; readonly y: number } & Size,
): View | undefined {
  const { x, y, k } = view;
  const [left, top] = [box.x * k + x, box.y * k + y];
  const [right, bottom] = [left + box.width * k, top + box.height * k];
  const byX = moved(left, right, MARGIN.left, viewport.width - MARGIN.right);
  const byY = moved(top, bottom, MARGIN.top, viewport.height - MARGIN.bottom);
  return byX === 0 && byY === 0 ? undefined : { x: x + byX, y: y + byY, k };
}

function moved(from: number, to: number, least: number, most: number): number {
  if (from >= least && to <= most) return 0;
  // If it is beyond the right or bottom edge, pan back, but keep its beginning visible.
  return Math.max(Math.min(0, most - to), least - from);
}
