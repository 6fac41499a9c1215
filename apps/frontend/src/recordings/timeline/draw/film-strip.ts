import { timeAt, type Span } from '../span.ts';

/** A place of the film strip. */
export interface FilmSlot {
  readonly x: number;
  readonly widthPx: number;
  /** When its picture came; undefined when none came while the slot lasts. */
  readonly frameMs: number | undefined;
}

/** The first of sorted times that is not before another; their number when all are. */
export function firstFrom(times: Float64Array, timeMs: number): number {
  let [low, high] = [0, times.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle]! < timeMs) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** Places of pictures side by side. They stand at fixed moments, so that panning moves them as they are. */
export function filmSlots(
  frames: Float64Array,
  span: Span,
  widthPx: number,
  slotPx: number,
): FilmSlot[] {
  const slotMs = timeAt(slotPx, span, widthPx) - span.fromMs;
  const slots: FilmSlot[] = [];
  for (let index = Math.floor(span.fromMs / slotMs); index * slotMs < span.untilMs; index++) {
    const startMs = index * slotMs;
    const frameMs = frames[firstFrom(frames, startMs)];
    slots.push({
      x: ((startMs - span.fromMs) / slotMs) * slotPx,
      widthPx: slotPx,
      frameMs: frameMs !== undefined && frameMs < startMs + slotMs ? frameMs : undefined,
    });
  }
  return slots;
}
