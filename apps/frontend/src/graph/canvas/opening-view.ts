import type { Size } from '../model/graph.ts';
import type { Box, View } from './stage-view.ts';
import { viewShowing } from './view-showing.ts';

/** Phones are narrower than this, pixels. */
const NARROW_PX = 760;
/** Rows and values can be read well from this zoom on. */
const READABLE_ZOOM = 0.7;
/** Smaller than this, seeing all of a graph is worth less than reading its beginning; phones are held closer. */
const WHOLE_ZOOM = { narrow: 0.45, wide: 0.6 };
const MARGIN = 24;
/** What lies over the top of the canvas, pixels. */
const TOP = 76;

/**
 * The view in which a graph opens that would be too small to be read as a whole: its beginning, with the first node that values
 * flow from.
 *
 * @param view shows all of it
 * @param boxes of its nodes
 * @returns undefined: all of it can be read
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
