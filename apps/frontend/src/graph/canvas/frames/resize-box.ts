import type { Point, Size } from '../../model/graph.ts';
import type { Box } from '../stage-view.ts';

/** Edges of a box that a handle moves: -1 left or top, 1 right or bottom. */
export interface Handle {
  readonly x: -1 | 0 | 1;
  readonly y: -1 | 0 | 1;
}

/** Kinds of nodes that users can resize. */
export type SizedKind = 'frame' | 'comment';

const LEAST: Readonly<Record<SizedKind, Size>> = {
  frame: { width: 120, height: 80 },
  comment: { width: 80, height: 30 },
};

export function limitSize(kind: SizedKind, { width, height }: Size): Size {
  const least = LEAST[kind];
  return {
    width: Math.round(Math.max(width, least.width)),
    height: Math.round(Math.max(height, least.height)),
  };
}

/** Returns the box after a handle was dragged; the opposite edges stay. */
export function resizeBox(
  kind: SizedKind,
  { x, y, width, height }: Box,
  handle: Handle,
  by: Point,
): Box {
  const wanted = { width: width + handle.x * by.x, height: height + handle.y * by.y };
  const size = limitSize(kind, wanted);
  return {
    x: handle.x < 0 ? x + width - size.width : x,
    y: handle.y < 0 ? y + height - size.height : y,
    ...size,
  };
}
