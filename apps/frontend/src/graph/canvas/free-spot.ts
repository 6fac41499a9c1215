import type { Graph, Point, Size } from '../model/graph.ts';
import type { CanvasStage } from './canvas-stage.ts';
import { overlaps } from './seen-area.ts';
import type { Box } from './stage-view.ts';

/** Grid of nodes and bend points, canvas units. */
export const GRID = 10;
/** Half of the size of a small node: centres a dropped node under the pointer. */
export const NODE_HALF: Point = { x: 90, y: 30 };
const NODE: Size = { width: 180, height: 76 };
const GAP = 20;
/** Factor on upward distances, so that free positions below are preferred. */
const UPWARDS = 1.5;
/** Most nodes considered around a position: the number of candidates grows quadratically. */
const MAX_AROUND = 60;

export const onGrid = ({ x, y }: Point): Point => ({
  x: Math.round(x / GRID) * GRID,
  y: Math.round(y / GRID) * GRID,
});

/** Constraints for a free position. */
export interface SpotWish {
  readonly size?: Size;
  /** Preferred area; positions outside are used only if there is none inside. */
  readonly area?: Box;
}

/** Returns the position itself if no node is there, otherwise the nearest free one. */
export function freeSpot(
  { positions, sizes }: Pick<CanvasStage, 'positions' | 'sizes'>,
  { nodes }: Pick<Graph, 'nodes'>,
  wish: Point,
  { size = NODE, area }: SpotWish = {},
): Point {
  const taken = [...positions].flatMap(([id, at]) => {
    if (nodes.get(id)?.kind === 'frame') return [];
    return [{ ...NODE, ...sizes.get(id), ...at }];
  });
  const isFree = (place: Point): boolean => {
    const box = { ...place, ...size };
    return !taken.some((other) => overlaps(box, other));
  };
  const start = area === undefined ? wish : inside(wish, size, area);
  const own = onGrid(start);
  if (isFree(own)) return own;
  const spots = beside(start, size, taken);
  const seen =
    area &&
    nearest(
      spots.filter((spot) => isInside(spot, size, area)),
      start,
      isFree,
    );
  return seen ?? nearest(spots, start, isFree) ?? own;
}

/** Positions adjacent to the nodes around; the nearest free one is always among them. */
function beside({ x, y }: Point, size: Size, taken: readonly Box[]): Point[] {
  const far = (box: Box): number => Math.hypot(box.x - x, box.y - y);
  const around = taken.toSorted((a, b) => far(a) - far(b)).slice(0, MAX_AROUND);
  const up = (value: number): number => Math.ceil(value / GRID) * GRID;
  const down = (value: number): number => Math.floor(value / GRID) * GRID;
  const own = onGrid({ x, y });
  const xs = new Set([own.x]);
  const ys = new Set([own.y]);
  for (const box of around) {
    xs.add(up(box.x + box.width + GAP)).add(down(box.x - size.width - GAP));
    ys.add(up(box.y + box.height + GAP)).add(down(box.y - size.height - GAP));
  }
  return [...xs].flatMap((left) => [...ys].map((top) => ({ x: left, y: top })));
}

function nearest(
  spots: readonly Point[],
  to: Point,
  isFree: (spot: Point) => boolean,
): Point | undefined {
  const way = ({ x, y }: Point): number =>
    Math.hypot(x - to.x, y < to.y ? UPWARDS * (y - to.y) : y - to.y);
  return spots
    .map((spot) => ({ spot, way: way(spot) }))
    .sort((a, b) => a.way - b.way)
    .find(({ spot }) => isFree(spot))?.spot;
}

function inside({ x, y }: Point, { width, height }: Size, area: Box): Point {
  const right = Math.floor((area.x + area.width - width) / GRID) * GRID;
  const bottom = Math.floor((area.y + area.height - height) / GRID) * GRID;
  return {
    x: Math.max(area.x, Math.min(x, right)),
    y: Math.max(area.y, Math.min(y, bottom)),
  };
}

const isInside = ({ x, y }: Point, { width, height }: Size, area: Box): boolean =>
  x >= area.x &&
  y >= area.y &&
  x + width <= area.x + area.width &&
  y + height <= area.y + area.height;
