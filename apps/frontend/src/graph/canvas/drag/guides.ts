import type { Point } from '../../model/graph.ts';
import { snapToOthers, type Axis, type Box } from '../../model/selection/arrange.ts';

/** Guide line across the canvas along which boxes align. */
export interface GuideLine {
  readonly axis: Axis;
  /** Coordinate of the line on its axis. */
  readonly at: number;
  /** Start and end of the line on the other axis. */
  readonly from: number;
  readonly to: number;
}

export interface Snapping {
  /** Visible boxes that do not move, as alignment targets. */
  readonly others: readonly Box[];
  /** Largest distance that snaps, in canvas units; 0: no alignment. */
  readonly reach: number;
  readonly grid: number;
  /** Point that snaps to the grid. */
  readonly anchor: Point;
}

/** Movement of a box after snapping, and its guide lines. */
export interface SnappedMove {
  readonly by: Point;
  readonly lines: readonly GuideLine[];
}

const onGrid = (value: number, grid: number): number => Math.round(value / grid) * grid;

/** Aligns with other boxes within reach, otherwise with the grid; each axis separately. */
export function snapMove(
  box: Box,
  by: Point,
  { others, reach, grid, anchor }: Snapping,
): SnappedMove {
  const free = {
    x: onGrid(anchor.x + by.x, grid) - anchor.x,
    y: onGrid(anchor.y + by.y, grid) - anchor.y,
  };
  if (reach <= 0) return { by: free, lines: [] };
  const moved = { ...box, x: box.x + by.x, y: box.y + by.y };
  const { point, guides } = snapToOthers(moved, others, reach);
  const has = (axis: Axis): boolean => guides.some((guide) => guide.axis === axis);
  const snapped = {
    x: has('x') ? Math.round(point.x - box.x) : free.x,
    y: has('y') ? Math.round(point.y - box.y) : free.y,
  };
  const placed = { ...box, x: box.x + snapped.x, y: box.y + snapped.y };
  return { by: snapped, lines: guides.map(({ axis, at }) => lineOf(axis, at, placed, others)) };
}

/** Aligning centres of odd sizes leaves half a pixel. */
const TOLERANCE = 0.75;

function lineOf(axis: Axis, at: number, box: Box, others: readonly Box[]): GuideLine {
  const extent = axis === 'x' ? 'width' : 'height';
  const [across, size] = axis === 'x' ? (['y', 'height'] as const) : (['x', 'width'] as const);
  const touches = (other: Box): boolean =>
    [0, 0.5, 1].some((share) => Math.abs(other[axis] + other[extent] * share - at) < TOLERANCE);
  const along = [box, ...others.filter(touches)];
  return {
    axis,
    at,
    from: Math.min(...along.map((one) => one[across])),
    to: Math.max(...along.map((one) => one[across] + one[size])),
  };
}
