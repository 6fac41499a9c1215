import type { Point } from '../../model/graph.ts';
import type { Box } from '../../model/selection/arrange.ts';

/** How much a way aside counts against a way ahead. */
const ASIDE = 2.5;

/**
 * The box next to another one in a direction.
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

/** The box whose middle is nearest to a place. */
export function nearestTo(boxes: readonly Box[], { x, y }: Point): Box | undefined {
  const far = (box: Box): number => Math.hypot(middleOf(box).x - x, middleOf(box).y - y);
  return boxes.toSorted((a, b) => far(a) - far(b))[0];
}

const middleOf = ({ x, y, width, height }: Box): Point => ({
  x: x + width / 2,
  y: y + height / 2,
});
