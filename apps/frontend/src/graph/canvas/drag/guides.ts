import type { Point } from '../../model/graph.ts';
import { snapToOthers, type Axis, type Box } from '../../model/selection/arrange.ts';

/** A thin line along which boxes line up, across the canvas. */
export interface GuideLine {
  readonly axis: Axis;
  /** Where it is on its axis. */
  readonly at: number;
  /** Where it begins and ends, on the other axis. */
  readonly from: number;
  readonly to: number;
}

export interface Snapping {
  /** What lies still and may be lined up with. */
  readonly others: readonly Box[];
  /** How near is near, in units of the canvas; 0: nothing is lined up. */
  readonly reach: number;
  readonly grid: number;
  /** What comes to lie on the grid. */
  readonly anchor: Point;
}

/** How far a box is really moved, and what it lines up with then. */
export interface SnappedMove {
  readonly by: Point;
  readonly lines: readonly GuideLine[];
}

const onGrid = (value: number, grid: number): number => Math.round(value / grid) * grid;

/** Lines up with others where that is near, else with the grid; each axis by itself. */
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

/** Half a pixel is lost where middles of odd sizes are lined up. */
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
