import type { Point, Size } from '../graph.ts';

/** Box of a node on the canvas. */
export interface Box extends Point, Size {
  readonly id: string;
}

export type Alignment = 'left' | 'center' | 'right' | 'top' | 'middle' | 'bottom';
export type Axis = 'x' | 'y';

/** New positions by node id, without nodes that stay. */
export type Places = ReadonlyMap<string, Point>;

/** Aligns nodes with the outermost of them, or with their common centre. */
export function align(boxes: readonly Box[], alignment: Alignment): Places {
  const around = bounds(boxes);
  return placed(boxes, (box) => {
    switch (alignment) {
      case 'left':
        return { x: around.x, y: box.y };
      case 'center':
        return { x: around.x + (around.width - box.width) / 2, y: box.y };
      case 'right':
        return { x: around.x + around.width - box.width, y: box.y };
      case 'top':
        return { x: box.x, y: around.y };
      case 'middle':
        return { x: box.x, y: around.y + (around.height - box.height) / 2 };
      case 'bottom':
        return { x: box.x, y: around.y + around.height - box.height };
    }
  });
}

/** Makes the gaps between nodes equal; the outermost ones stay. No effect on fewer than three. */
export function distribute(boxes: readonly Box[], axis: Axis): Places {
  if (boxes.length < 3) return new Map();
  const extent = axis === 'x' ? 'width' : 'height';
  const sorted = [...boxes].sort((a, b) => a[axis] - b[axis]);
  const around = bounds(boxes);
  const total = sorted.reduce((sum, box) => sum + box[extent], 0);
  const gap = (around[extent] - total) / (sorted.length - 1);
  const starts = new Map<string, number>();
  let next = around[axis];
  for (const box of sorted) {
    starts.set(box.id, next);
    next += box[extent] + gap;
  }
  return placed(boxes, (box) => ({ x: box.x, y: box.y, [axis]: starts.get(box.id) ?? box[axis] }));
}

export function snap({ x, y }: Point, grid: number): Point {
  const to = (value: number): number => Math.round(value / grid) * grid + 0;
  return { x: to(x), y: to(y) };
}

/** Guide line along which a dragged node would align with others. */
export interface Guide {
  readonly axis: Axis;
  /** Coordinate of the line. */
  readonly at: number;
}

/** Moves a box so that an edge or its centre aligns with another box, if one is near. */
export function snapToOthers(
  box: Box,
  others: readonly Box[],
  reach: number,
): { readonly point: Point; readonly guides: readonly Guide[] } {
  const x = nearest(box.x, box.width, others, 'x', 'width', reach);
  const y = nearest(box.y, box.height, others, 'y', 'height', reach);
  return {
    point: { x: box.x + (x?.by ?? 0), y: box.y + (y?.by ?? 0) },
    guides: [
      ...(x === undefined ? [] : [{ axis: 'x', at: x.at } as const]),
      ...(y === undefined ? [] : [{ axis: 'y', at: y.at } as const]),
    ],
  };
}

function nearest(
  start: number,
  length: number,
  others: readonly Box[],
  axis: Axis,
  extent: 'width' | 'height',
  reach: number,
): { readonly by: number; readonly at: number } | undefined {
  let best: { by: number; at: number } | undefined;
  for (const other of others) {
    for (const share of [0, 0.5, 1]) {
      const at = other[axis] + other[extent] * share;
      const by = at - (start + length * share);
      const distance = Math.abs(by);
      if (best === undefined ? distance <= reach : distance < Math.abs(best.by)) best = { by, at };
    }
  }
  return best;
}

/** Bounding box; empty for no boxes. */
export function bounds(boxes: readonly (Point & Size)[]): Point & Size {
  if (boxes.length === 0) return { x: 0, y: 0, width: 0, height: 0 };
  let [left, top, right, bottom] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const { x, y, width, height } of boxes) {
    left = Math.min(left, x);
    top = Math.min(top, y);
    right = Math.max(right, x + width);
    bottom = Math.max(bottom, y + height);
  }
  return { x: left, y: top, width: right - left, height: bottom - top };
}

function placed(boxes: readonly Box[], place: (box: Box) => Point): Places {
  const places = new Map<string, Point>();
  for (const box of boxes) {
    const { x, y } = place(box);
    const point = { x: Math.round(x), y: Math.round(y) };
    if (point.x !== box.x || point.y !== box.y) places.set(box.id, point);
  }
  return places;
}
