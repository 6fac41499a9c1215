import { endOf, follow, panBy, zoomBy, type PlotView, type ViewBounds } from './plot-view.ts';

/** State that keys change. */
export interface KeyTarget {
  readonly view: PlotView;
  readonly bounds: ViewBounds;
  /** Width of the plot, pixels. */
  readonly width: number;
  readonly readingX: number | undefined;
}

/** Effect of a key; `undefined` for other keys. */
export type KeyEffect =
  | { readonly view: PlotView }
  | { readonly readingX: number | undefined }
  | { readonly cursor: 0 | 1; readonly x: number }
  | { readonly pickX: number };

/** Step of the reading line and of panning, as shares of the plot's width. */
const READ_STEP = 0.01;
const PAN_STEP = 0.1;
const ZOOM_STEP = 1.4;

export const PLOT_KEYS_HELP =
  'Arrow keys move the reading line; with Shift they move the time. Plus and minus zoom, Home follows the newest value. ' +
  'A and B set the cursors at the reading line, Enter opens the record there.';

export function effectOfKey(
  { key, shiftKey }: Pick<KeyboardEvent, 'key' | 'shiftKey'>,
  { view, bounds, width, readingX }: KeyTarget,
): KeyEffect | undefined {
  const x = readingX ?? width;
  const timeMs = endOf(view, bounds) - view.spanMs + (x / width) * view.spanMs;
  switch (key) {
    case 'ArrowLeft':
    case 'ArrowRight': {
      const direction = key === 'ArrowLeft' ? -1 : 1;
      if (shiftKey) return { view: panBy(view, direction * PAN_STEP * view.spanMs, bounds) };
      const moved = x + direction * READ_STEP * width;
      return { readingX: Math.min(width, Math.max(0, moved)) };
    }
    case 'PageUp':
      return { view: panBy(view, -view.spanMs, bounds) };
    case 'PageDown':
      return { view: panBy(view, view.spanMs, bounds) };
    case '+':
    case '=':
      return { view: zoomBy(view, 1 / ZOOM_STEP, timeMs, bounds) };
    case '-':
      return { view: zoomBy(view, ZOOM_STEP, timeMs, bounds) };
    case 'Home':
    case '0':
      return { view: follow(view) };
    case 'a':
    case 'A':
      return { cursor: 0, x };
    case 'b':
    case 'B':
      return { cursor: 1, x };
    case 'Enter':
      return { pickX: x };
    case 'Escape':
      return { readingX: undefined };
    default:
      return undefined;
  }
}
