import { xOf } from '../span.ts';
import type { Run } from '../run-log.ts';
import type { TilePiece } from '../tile-store.ts';
import type { Pen, TrackView } from './track-canvas.ts';

const TICK_PX = 1.5;
/** Ticks no closer than this, pixels: closer ones are one. */
const STEP_PX = 2.5;
const HELD_PX = 3;

/** Columns of pixels in which records came. */
export function* tickColumns(
  pieces: readonly TilePiece[],
  { span, widthPx }: TrackView,
): Generator<number> {
  let last = -Infinity;
  for (const { tile, fromMs, untilMs } of pieces) {
    const { fromMs: startMs, bucketMs, buckets } = tile.grid;
    const end = Math.min(buckets, Math.ceil((untilMs - startMs) / bucketMs));
    for (
      let bucket = Math.max(0, Math.floor((fromMs - startMs) / bucketMs));
      bucket < end;
      bucket++
    ) {
      if (tile.counts[bucket] === 0) continue;
      const x = xOf(startMs + (bucket + 0.5) * bucketMs, span, widthPx);
      if (x - last < STEP_PX) continue;
      last = x;
      yield x;
    }
  }
}

/** Draws a tick for each record. */
export function drawTicks(
  pen: Pen,
  pieces: readonly TilePiece[],
  view: TrackView,
  heightPx: number,
): void {
  const top = (view.heightPx - heightPx) / 2;
  for (const x of tickColumns(pieces, view)) pen.fillRect(x - TICK_PX / 2, top, TICK_PX, heightPx);
}

/** Draws under ticks for how long something was held. */
export function drawHeld(
  pen: Pen,
  runs: readonly Run[],
  { span, widthPx, heightPx }: TrackView,
): void {
  for (const { fromMs, untilMs } of runs) {
    if (untilMs < span.fromMs || fromMs > span.untilMs) continue;
    const x = xOf(fromMs, span, widthPx);
    const width = Math.max(1, xOf(untilMs, span, widthPx) - x);
    pen.fillRect(x, heightPx - HELD_PX - 3, width, HELD_PX);
  }
}
