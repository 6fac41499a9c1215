import type { Size } from '../../model/graph.ts';
import type { Box, View } from '../stage-view.ts';

/** Phones are narrower than this, pixels. */
const NARROW_PX = 760;
/** Rows and values can be read well from this zoom on. */
const READABLE_ZOOM = 0.7;
/** Below this zoom, the beginning of a graph is shown readable instead of all of it. */
const WHOLE_ZOOM = 0.4;
const MARGIN = 24;
/** What lies over the top of the canvas, pixels. */
const TOP = 76;

/**
 * On a phone, a graph that would be too small to be read as a whole is shown from its beginning.
 * @param view shows all of it; undefined: that can be read
 */
export function readableView(view: View, box: Box | undefined, { width }: Size): View | undefined {
  if (box === undefined || width === 0 || width >= NARROW_PX || view.k >= WHOLE_ZOOM)
    return undefined;
  return {
    k: READABLE_ZOOM,
    x: MARGIN - box.x * READABLE_ZOOM,
    y: TOP - box.y * READABLE_ZOOM,
  };
}
