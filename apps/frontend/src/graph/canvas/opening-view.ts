import type { Size } from '../model/graph.ts';
import type { Box, View } from './stage-view.ts';
import { viewShowing } from './view-showing.ts';

/** Width below which a screen counts as a phone, pixels. */
const NARROW_PX = 760;
/** Smallest zoom at which rows and values are easy to read. */
const READABLE_ZOOM = 0.7;
/** Smallest zoom at which a graph opens as a whole; below, its beginning is shown. Phones are held closer. */
const WHOLE_ZOOM = { narrow: 0.45, wide: 0.6 };
const MARGIN = 24;
/** Height at the top of the canvas that toolbars cover, pixels. */
const TOP = 76;

/**
 * Returns the initial view for a graph that is too large to be read as a whole: its beginning, with the first node in
 * the direction of the data.
 *
 * @param view that shows the whole graph
 * @param boxes of its nodes
 * @returns undefined when the whole graph is readable
 */
export function openingView(
  view: View,
  boxes: readonly Box[],
  all: Box | undefined,
  viewport: Size,
): View | undefined {
  const [first] = [...boxes].sort((a, b) => a.x - b.x || a.y - b.y);
  const whole = viewport.width < NARROW_PX ? WHOLE_ZOOM.narrow : WHOLE_ZOOM.wide;
  if (first === undefined || all === undefined || viewport.width === 0 || view.k >= whole) {
    return undefined;
  }
  const k = READABLE_ZOOM;
  const free = viewport.width - all.width * k;
  const beginning = {
    k,
    x: Math.max(MARGIN, free / 2) - all.x * k,
    y: TOP - all.y * k,
  };
  return viewShowing(beginning, viewport, first) ?? beginning;
}
