import type { Point, Size } from '../../model/graph.ts';
import type { Box } from '../../model/selection/arrange.ts';

/** Weight of sideways distance relative to distance ahead. */
const ASIDE = 2.5;

/**
 * Returns the nearest box in a direction.
 * @param way one of the four unit vectors
 */
export function neighbour(boxes: readonly Box[], from: Box, way: Point): Box | undefined {
  const isAcross = way.x !== 0;
  const start = middleOf(from);
  let best: Box | undefined;
  let least = Infinity;
  for (const box of boxes) {
    if (box.id === from.id) continue;
    const middle = middleOf(box);
    const [dx, dy] = [middle.x - start.x, middle.y - start.y];
    const ahead = isAcross ? dx * way.x : dy * way.y;
    if (ahead <= 1) continue;
    const aside = Math.abs(isAcross ? dy : dx);
    const far = ahead + ASIDE * aside;
    if (far < least) [best, least] = [box, far];
  }
  return best;
}

/**
 * Returns the first box in an area in the direction of the data: the leftmost, then the topmost; of all boxes when the
 * area has none.
 */
export function firstIn(boxes: readonly Box[], area: Point & Size): Box | undefined {
  const isIn = ({ x, y, width, height }: Box): boolean =>
    x < area.x + area.width &&
    x + width > area.x &&
    y < area.y + area.height &&
    y + height > area.y;
  const seen = boxes.filter(isIn);
  const order = seen.length > 0 ? seen : boxes;
  return order.toSorted((a, b) => a.x - b.x || a.y - b.y)[0];
}

const middleOf = ({ x, y, width, height }: Box): Point => ({
  x: x + width / 2,
  y: y + height / 2,
});
