import { xOf } from '../span.ts';
import type { Tile } from '../tile.ts';
import type { TilePiece } from '../tile-store.ts';
import type { Pen, TrackView } from './track-canvas.ts';

/** The lowest and highest number of a track: its value axis. */
export interface ValueRange {
  readonly low: number;
  readonly high: number;
}

/** Free above and below the lines, share of the height. */
const MARGIN = 0.12;

/** The range of all lines of a tile; undefined when there are no numbers. */
export function rangeOf({ lines }: Tile): ValueRange | undefined {
  let [low, high] = [Infinity, -Infinity];
  for (const line of lines) {
    for (const number of line.low) if (number < low) low = number;
    for (const number of line.high) if (number > high) high = number;
  }
  if (low > high) return undefined;
  return low === high ? { low: low - 1, high: high + 1 } : { low, high };
}

export function yOf(value: number, { low, high }: ValueRange, heightPx: number): number {
  const share = (value - low) / (high - low);
  return heightPx * (1 - MARGIN - share * (1 - 2 * MARGIN));
}

/** One column of pixels of a line. */
export interface Column {
  readonly x: number;
  readonly low: number;
  readonly high: number;
  /** Milliseconds since the column before. */
  readonly sinceMs: number;
}

/** The columns of one line, buckets of one pixel put together. */
export function* columnsOf(
  pieces: readonly TilePiece[],
  line: number,
  { span, widthPx }: TrackView,
): Generator<Column> {
  let [x, low, high, timeMs, lastMs] = [NaN, NaN, NaN, NaN, -Infinity];
  for (const { tile, fromMs, untilMs } of pieces) {
    const numbers = tile.lines[line];
    if (numbers === undefined) continue;
    const { fromMs: startMs, bucketMs, buckets } = tile.grid;
    const last = Math.min(buckets, Math.ceil((untilMs - startMs) / bucketMs));
    for (
      let bucket = Math.max(0, Math.floor((fromMs - startMs) / bucketMs));
      bucket < last;
      bucket++
    ) {
      const bottom = numbers.low[bucket]!;
      if (Number.isNaN(bottom)) continue;
      const top = numbers.high[bucket]!;
      const middleMs = startMs + (bucket + 0.5) * bucketMs;
      const column = Math.floor(xOf(middleMs, span, widthPx)) + 0.5;
      if (column === x) {
        low = Math.min(low, bottom);
        high = Math.max(high, top);
        continue;
      }
      if (!Number.isNaN(x)) {
        yield { x, low, high, sinceMs: timeMs - lastMs };
        lastMs = timeMs;
      }
      [x, low, high, timeMs] = [column, bottom, top, middleMs];
    }
  }
  if (!Number.isNaN(x)) yield { x, low, high, sinceMs: timeMs - lastMs };
}

/** Draws one line; where nothing came for longer than the gap, it is interrupted. */
export function drawLine(
  pen: Pen,
  columns: Iterable<Column>,
  range: ValueRange,
  { heightPx }: TrackView,
  gapMs: number,
): void {
  let lastY = 0;
  pen.beginPath();
  for (const { x, low, high, sinceMs } of columns) {
    const [bottom, top] = [yOf(low, range, heightPx), yOf(high, range, heightPx)];
    const isFirst = sinceMs > gapMs;
    const [near, far] =
      Math.abs(bottom - lastY) < Math.abs(top - lastY) ? [bottom, top] : [top, bottom];
    // A point alone has a length, or it would not be seen
    if (isFirst) pen.moveTo(x - 0.75, near);
    pen.lineTo(x, near);
    if (far !== near) pen.lineTo(x, far);
    lastY = far;
  }
  pen.stroke();
}

/** Columns with a pixel between two, and as high as the values in them. */
const BAR_PX = 2;

/** Draws what is dense as bars from the lowest to the highest value. */
export function drawEnvelope(
  pen: Pen,
  columns: Iterable<Column>,
  range: ValueRange,
  { heightPx }: TrackView,
): void {
  let [bar, low, high] = [NaN, Infinity, -Infinity];
  const draw = (): void => {
    if (Number.isNaN(bar)) return;
    const top = yOf(high, range, heightPx);
    const height = Math.max(1, yOf(low, range, heightPx) - top);
    pen.fillRect(bar * BAR_PX, top, BAR_PX - 0.7, height);
  };
  for (const column of columns) {
    const next = Math.floor(column.x / BAR_PX);
    if (next !== bar) {
      draw();
      [bar, low, high] = [next, Infinity, -Infinity];
    }
    low = Math.min(low, column.low);
    high = Math.max(high, column.high);
  }
  draw();
}
