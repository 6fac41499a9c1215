/** A stretch of a recording, milliseconds since its beginning. */
export interface Span {
  readonly fromMs: number;
  readonly untilMs: number;
}

/** No closer than this can be looked, milliseconds across the view. */
const MIN_SPAN_MS = 1;

export const lengthOf = ({ fromMs, untilMs }: Span): number => untilMs - fromMs;

/** Where a moment lies in a view, pixels from its left edge. */
export const xOf = (timeMs: number, span: Span, widthPx: number): number =>
  ((timeMs - span.fromMs) / lengthOf(span)) * widthPx;

/** The moment at a place in a view. */
export const timeAt = (x: number, span: Span, widthPx: number): number =>
  span.fromMs + (x / Math.max(1, widthPx)) * lengthOf(span);

/** The nearest span of the same length inside the recording; all of it when the length is larger. */
export function clampSpan({ fromMs, untilMs }: Span, durationMs: number): Span {
  const most = Math.max(MIN_SPAN_MS, durationMs);
  const length = Math.min(most, Math.max(MIN_SPAN_MS, untilMs - fromMs));
  const from = Math.min(Math.max(0, fromMs), most - length);
  return { fromMs: from, untilMs: from + length };
}

/** Zooms with one moment standing still. @param factor below 1 looks closer */
export function zoomSpan(span: Span, factor: number, aroundMs: number, durationMs: number): Span {
  const length = Math.min(
    Math.max(MIN_SPAN_MS, lengthOf(span) * factor),
    Math.max(MIN_SPAN_MS, durationMs),
  );
  const share = (aroundMs - span.fromMs) / lengthOf(span);
  const fromMs = aroundMs - share * length;
  return clampSpan({ fromMs, untilMs: fromMs + length }, durationMs);
}

export const panSpan = ({ fromMs, untilMs }: Span, byMs: number, durationMs: number): Span =>
  clampSpan({ fromMs: fromMs + byMs, untilMs: untilMs + byMs }, durationMs);

/** The span that has a moment in view, moved by a page when the moment has left it. */
export function spanShowing(span: Span, timeMs: number, durationMs: number): Span {
  if (timeMs >= span.fromMs && timeMs <= span.untilMs) return span;
  const length = lengthOf(span);
  const fromMs = timeMs > span.untilMs ? timeMs - length * 0.1 : timeMs - length * 0.9;
  return clampSpan({ fromMs, untilMs: fromMs + length }, durationMs);
}

/** A span drawn from one moment to another, in either direction. */
export const spanBetween = (aMs: number, bMs: number): Span => ({
  fromMs: Math.min(aMs, bMs),
  untilMs: Math.max(aMs, bMs),
});
