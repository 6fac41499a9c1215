import type { Size } from '../model/graph.ts';
import type { Box, View } from './stage-view.ts';

/** Level of detail at a zoom. Far: title and state of nodes. Plain: wires show only rates. Near: everything. */
export type Detail = 'far' | 'plain' | 'near';

const FAR_ZOOM = 0.45;
const PLAIN_ZOOM = 0.7;
/** Margin drawn around the visible part, page pixels: panning within it draws nothing new. */
const MARGIN = 240;

export function detailAt(zoom: number): Detail {
  if (zoom < FAR_ZOOM) return 'far';
  return zoom < PLAIN_ZOOM ? 'plain' : 'near';
}

/** Returns the area to draw: the visible part with a margin; the previous area while it suffices. */
export function seenArea(view: View, viewport: Size, before: Box | undefined): Box {
  const seen = around(view, viewport, 0);
  const next = around(view, viewport, MARGIN);
  const isEnough =
    before !== undefined && before.width <= 1.5 * next.width && contains(before, seen);
  return isEnough ? before : next;
}

function around({ x, y, k }: View, { width, height }: Size, margin: number): Box {
  return {
    x: (-x - margin) / k,
    y: (-y - margin) / k,
    width: (width + 2 * margin) / k,
    height: (height + 2 * margin) / k,
  };
}

function contains(outer: Box, inner: Box): boolean {
  return (
    inner.x >= outer.x &&
    inner.y >= outer.y &&
    inner.x + inner.width <= outer.x + outer.width &&
    inner.y + inner.height <= outer.y + outer.height
  );
}

/** True when two boxes have something in common. */
export function overlaps(a: Box, b: Box): boolean {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}
