import type { Size } from '../model/graph.ts';
import { clearViewOf, NO_COVER, type Box, type View } from './stage-view.ts';

/**
 * Returns the view after the lower part of the canvas was covered: of a graph that was visible as a whole, all of it;
 * otherwise what was in the middle stays in the middle.
 * @param boxes of all nodes
 * @param viewport before
 * @param covered height, pixels
 */
export function coveredView(
  view: View,
  boxes: readonly Box[],
  viewport: Size,
  covered: number,
): View {
  const isSeen = ({ x, y, width, height }: Box): boolean =>
    x * view.k + view.x >= 0 &&
    y * view.k + view.y >= 0 &&
    (x + width) * view.k + view.x <= viewport.width &&
    (y + height) * view.k + view.y <= viewport.height;
  if (boxes.length === 0 || !boxes.every(isSeen)) return { ...view, y: view.y - covered / 2 };
  const left = { ...viewport, height: viewport.height - covered };
  if (boxes.every(({ y, height }) => (y + height) * view.k + view.y <= left.height)) return view;
  return clearViewOf(boxes, left, NO_COVER);
}
