import type { Graph, Point } from '../model/graph.ts';
import type { CanvasStage } from './canvas-stage.ts';

/** What nodes and points lie on. */
export const GRID = 10;
/** Half of a small node: what is dropped lies under the pointer. */
export const NODE_HALF: Point = { x: 90, y: 30 };
const NODE = { width: 180, height: 76 };
const GAP = 20;
const MAX_TRIES = 50;

export const onGrid = ({ x, y }: Point): Point => ({
  x: Math.round(x / GRID) * GRID,
  y: Math.round(y / GRID) * GRID,
});

/** The place itself, or below it, where no node is in the way. */
export function freeSpot(
  { positions, sizes }: Pick<CanvasStage, 'positions' | 'sizes'>,
  { nodes }: Pick<Graph, 'nodes'>,
  { x, y }: Point,
): Point {
  const taken = [...positions].flatMap(([id, at]) => {
    if (nodes.get(id)?.kind === 'frame') return [];
    return [{ ...NODE, ...sizes.get(id), ...at }];
  });
  let free = y;
  for (let tries = 0; tries < MAX_TRIES; tries += 1) {
    const hit = taken.find(
      (box) =>
        box.x < x + NODE.width &&
        box.x + box.width > x &&
        box.y < free + NODE.height &&
        box.y + box.height > free,
    );
    if (hit === undefined) break;
    free = hit.y + hit.height + GAP;
  }
  return onGrid({ x, y: free });
}
