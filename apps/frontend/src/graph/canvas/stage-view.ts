import type { Point, Size } from '../model/graph.ts';
import { bounds } from '../model/selection/arrange.ts';

/** View of the canvas: position of its origin in pixels, and the zoom `k`. */
export interface View extends Point {
  readonly k: number;
}

/** Rectangle in canvas coordinates. */
export interface Box extends Point, Size {}

export const MIN_ZOOM = 0.1;
export const MAX_ZOOM = 2.5;
/** Largest margin on each side, as a share of the width. */
const NARROW_MARGIN = 0.05;
/** Fitting does not enlarge small graphs. */
const MAX_FIT_ZOOM = 1;

/** Smallest distance of a socket from the bottom of its node, pixels. */
const SOCKET_INSET = 12;

/**
 * Clamps the position of a socket to its node. At a far zoom, browsers keep the old height of rows that they do not
 * render: sockets below the border are drawn at its end.
 */
export const insideNode = ({ x, y }: Point, { height }: Size): Point => ({
  x,
  y: height > 0 ? Math.min(y, height - SOCKET_INSET) : y,
});

export const limitZoom = (k: number): number => Math.min(MAX_ZOOM, Math.max(MIN_ZOOM, k));

/** At the top stand the toolbar and two lines of the description of a session. */
const MARGINS = { top: 72, side: 56, bottom: 56 };

/** Returns the view that shows a whole box. @param inset height at the bottom that is covered, pixels */
export function viewOf(box: Box, viewport: Size, inset = 0, margins = MARGINS): View {
  const { top, bottom } = margins;
  // On narrow canvases, names need the room.
  const side = Math.min(margins.side, viewport.width * NARROW_MARGIN);
  const width = viewport.width - 2 * side;
  const height = viewport.height - top - bottom - inset;
  const k = Math.max(
    MIN_ZOOM,
    Math.min(width / Math.max(box.width, 1), height / Math.max(box.height, 1), MAX_FIT_ZOOM),
  );
  return {
    x: side + (width - box.width * k) / 2 - box.x * k,
    y: top + (height - box.height * k) / 2 - box.y * k,
    k,
  };
}

/** What floats over a canvas. */
export interface Cover {
  /** Height at the bottom that is covered, pixels. */
  readonly bottom: number;
  /** Returns the size that is covered in the right bottom corner, pixels. */
  readonly corner: (viewport: Size) => Size | undefined;
}

export const NO_COVER: Cover = { bottom: 0, corner: () => undefined };

/** Returns the view that shows all boxes, none of them behind what covers the canvas. */
export function clearViewOf(
  boxes: readonly Box[],
  viewport: Size,
  { bottom, corner }: Cover,
): View {
  const all = bounds(boxes);
  const view = viewOf(all, viewport, bottom);
  const covered = corner(viewport);
  if (covered === undefined) return view;
  const isCovered = ({ x, y, width, height }: Box): boolean =>
    (x + width) * view.k + view.x > viewport.width - covered.width &&
    (y + height) * view.k + view.y > viewport.height - covered.height;
  if (!boxes.some(isCovered)) return view;
  const beside = viewOf(all, { ...viewport, width: viewport.width - covered.width }, bottom);
  const above = viewOf(all, viewport, Math.max(bottom, covered.height - MARGINS.bottom));
  return above.k > beside.k ? above : beside;
}
