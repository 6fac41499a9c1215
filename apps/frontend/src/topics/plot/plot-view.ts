/** Which stretch of time a plot shows. */
export interface PlotView {
  readonly spanMs: number;
  /** Its right edge, this machine's clock; `undefined` while it follows the newest. */
  readonly endMs: number | undefined;
}

/** What a view may show. */
export interface ViewBounds {
  /** The end of what there is: now, or where the page stands still. */
  readonly newestMs: number;
  /** How far back anything is kept. */
  readonly oldestMs: number;
}

export const MIN_SPAN_MS = 20;
export const MAX_SPAN_MS = 600_000;

const within = (value: number, min: number, max: number): number =>
  Math.min(max, Math.max(min, value));

const clampSpan = (spanMs: number): number => within(spanMs, MIN_SPAN_MS, MAX_SPAN_MS);

/** Not past the newest, and not where nothing is kept any more. */
function clampEnd(endMs: number, spanMs: number, { newestMs, oldestMs }: ViewBounds): number {
  return within(endMs, Math.min(newestMs, oldestMs + spanMs), newestMs);
}

export const endOf = ({ endMs }: PlotView, { newestMs }: ViewBounds): number => endMs ?? newestMs;

/** Exactly a stretch that was drawn with the pointer, from either side. */
export function zoomTo(fromMs: number, toMs: number, bounds: ViewBounds): PlotView {
  const spanMs = clampSpan(Math.abs(toMs - fromMs));
  const middleMs = (fromMs + toMs) / 2;
  return { spanMs, endMs: clampEnd(middleMs + spanMs / 2, spanMs, bounds) };
}

/**
 * Larger or smaller about one moment, which stays where it is. A view that follows goes on following
 * and keeps its right edge.
 * @param factor below 1 to see less time
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

/** Earlier or later. At the newest, going on means following again. @param byMs negative for earlier */
export function panBy(view: PlotView, byMs: number, bounds: ViewBounds): PlotView {
  const wanted = endOf(view, bounds) + byMs;
  if (wanted >= bounds.newestMs) return { spanMs: view.spanMs, endMs: undefined };
  return { spanMs: view.spanMs, endMs: clampEnd(wanted, view.spanMs, bounds) };
}

/** A moment into the middle, unless it is seen already. */
export function reveal(view: PlotView, timeMs: number, bounds: ViewBounds): PlotView {
  const endMs = endOf(view, bounds);
  if (timeMs <= endMs && timeMs >= endMs - view.spanMs) return view;
  return {
    spanMs: view.spanMs,
    endMs: clampEnd(timeMs + view.spanMs / 2, view.spanMs, bounds),
  };
}

export const follow = (view: PlotView): PlotView => ({ spanMs: view.spanMs, endMs: undefined });
