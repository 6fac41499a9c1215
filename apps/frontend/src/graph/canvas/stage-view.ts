import type { Point, Size } from '../model/graph.ts';

/** Where the canvas is looked at: the place of its origin in pixels, and the zoom. */
export interface View extends Point {
  readonly k: number;
}

/** A box on the canvas. */
export interface Box extends Point, Size {}

export const MIN_ZOOM = 0.1;
export const MAX_ZOOM = 2.5;
const FIT_MARGIN = 56;
/** Share of the width that is left free at each side, at most. */
const NARROW_MARGIN = 0.05;
/** Fitting does not blow up small graphs. */
const MAX_FIT_ZOOM = 1;

/** Closest to the bottom of its node that a socket is, pixels. */
const SOCKET_INSET = 12;

/**
 * Where a socket is in its node. From afar, browsers keep the height of rows that they do not draw, while the rows change:
 * sockets below the frame are drawn at its end.
 */
export const insideNode = ({ x, y }: Point, { height }: Size): Point => ({
  x,
  y: height > 0 ? Math.min(y, height - SOCKET_INSET) : y,
});

export const limitZoom = (k: number): number => Math.min(MAX_ZOOM, Math.max(MIN_ZOOM, k));

/** The view that shows all of a box. @param inset pixels at the bottom that something covers */
export function viewOf(box: Box, viewport: Size, inset = 0): View {
  // On a narrow canvas the names need the room
  const side = Math.min(FIT_MARGIN, viewport.width * NARROW_MARGIN);
  const width = viewport.width - 2 * side;
  const height = viewport.height - 2 * FIT_MARGIN - inset;
  const k = Math.max(
    MIN_ZOOM,
    Math.min(width / Math.max(box.width, 1), height / Math.max(box.height, 1), MAX_FIT_ZOOM),
  );
  return {
    x: side + (width - box.width * k) / 2 - box.x * k,
    y: FIT_MARGIN + (height - box.height * k) / 2 - box.y * k,
    k,
  };
}
