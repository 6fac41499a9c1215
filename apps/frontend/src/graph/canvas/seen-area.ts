import type { Size } from '../model/graph.ts';
import type { Box, View } from './stage-view.ts';

/**
 * How much can be read at a zoom. Far: nodes are a title and a state. Plain: wires say only how often.
 * Near: all.
 */
export type Detail = 'far' | 'plain' | 'near';

const FAR_ZOOM = 0.45;
const PLAIN_ZOOM = 0.7;
/** Drawn around what is seen, pixels of the page: as far can be panned before more is drawn. */
const MARGIN = 240;

export function detailAt(zoom: number): Detail {
  if (zoom < FAR_ZOOM) return 'far';
  return zoom < PLAIN_ZOOM ? 'plain' : 'near';
}

/** What is drawn of the canvas, with some room; the same box as before while that is enough. */
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
