/** Visible time range of a plot. */
export interface PlotView {
  readonly spanMs: number;
  /** Its right edge, this computer's clock; `undefined` while it follows the newest data. */
  readonly endMs: number | undefined;
}

/** Limits of a view. */
export interface ViewBounds {
  /** Latest time: now, or when the page was paused. */
  readonly newestMs: number;
  /** Time of the oldest data kept. */
  readonly oldestMs: number;
}

export const MIN_SPAN_MS = 20;
export const MAX_SPAN_MS = 600_000;

const within = (value: number, min: number, max: number): number =>
  Math.min(max, Math.max(min, value));

const clampSpan = (spanMs: number): number => within(spanMs, MIN_SPAN_MS, MAX_SPAN_MS);

/** Keeps the end between the oldest and the newest data. */
function clampEnd(endMs: number, spanMs: number, { newestMs, oldestMs }: ViewBounds): number {
  return within(endMs, Math.min(newestMs, oldestMs + spanMs), newestMs);
}

export const endOf = ({ endMs }: PlotView, { newestMs }: ViewBounds): number => endMs ?? newestMs;

/** Shows exactly the range that was drawn with the pointer, in either direction. */
export function zoomTo(fromMs: number, toMs: number, bounds: ViewBounds): PlotView {
  const spanMs = clampSpan(Math.abs(toMs - fromMs));
  const middleMs = (fromMs + toMs) / 2;
  return { spanMs, endMs: clampEnd(middleMs + spanMs / 2, spanMs, bounds) };
}

/**
 * Zooms around a time, which keeps its position. A view that follows the newest data keeps its right edge.
 * @param factor below 1 zooms in
 */
export function zoomBy(
  view: PlotView,
  factor: number,
  aboutMs: number,
  bounds: ViewBounds,
): PlotView {
  const spanMs = clampSpan(view.spanMs * factor);
  if (view.endMs === undefined) return { spanMs, endMs: undefined };
  const share = (view.endMs - aboutMs) / view.spanMs;
  return { spanMs, endMs: clampEnd(aboutMs + share * spanMs, spanMs, bounds) };
}

/** Pans. At the newest data, the view follows it again. @param byMs negative for earlier */
export function panBy(view: PlotView, byMs: number, bounds: ViewBounds): PlotView {
  const wanted = endOf(view, bounds) + byMs;
  if (wanted >= bounds.newestMs) return { spanMs: view.spanMs, endMs: undefined };
  return { spanMs: view.spanMs, endMs: clampEnd(wanted, view.spanMs, bounds) };
}

/** Centres a time, unless it is visible. */
export function reveal(view: PlotView, timeMs: number, bounds: ViewBounds): PlotView {
  const endMs = endOf(view, bounds);
  if (timeMs <= endMs && timeMs >= endMs - view.spanMs) return view;
  return {
    spanMs: view.spanMs,
    endMs: clampEnd(timeMs + view.spanMs / 2, view.spanMs, bounds),
  };
}

export const follow = (view: PlotView): PlotView => ({ spanMs: view.spanMs, endMs: undefined });
