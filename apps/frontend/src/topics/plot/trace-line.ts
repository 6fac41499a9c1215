import type { LinePoints } from '../history/series-ring.ts';
import { PixelColumns } from './pixel-columns.ts';
import type { PathSink, TimeWindow, TraceOptions } from './trace-options.ts';
import type { Range } from './value-axis.ts';

/** Points for each pixel from which on only the extremes of a pixel are drawn. */
const DENSE = 3;

/**
 * A line as it is drawn again and again. Where points are dense it draws the lowest and the highest of
 * each pixel, so that no peak is lost and the work depends on pixels, not on points: what was counted
 * for a pixel is kept as long as the window only moves on.
 */
export class TracedLine {
  readonly line: LinePoints;
  readonly #columns: PixelColumns;
  #isDense = false;

  constructor(line: LinePoints) {
    this.line = line;
    this.#columns = new PixelColumns(line);
  }

  /** The lowest and the highest value in a window, with the one before it, which is held into it. */
  rangeIn(window: TimeWindow): Range | undefined {
    this.#look(window);
    return this.#isDense ? this.#columns.range() : plainRange(this.line, window);
  }

  /** With one point beyond each end of the window. Gaps and what is no number stay open. */
  trace(options: TraceOptions, sink: PathSink): void {
    this.#look(options.window);
    if (this.#isDense) this.#columns.trace(options, sink);
    else tracePlain(this.line, options, sink);
  }

  #look(window: TimeWindow): void {
    const { line } = this;
    const points = line.indexAtOrAfter(window.endMs) - line.indexAtOrAfter(window.startMs);
    this.#isDense = points > DENSE * window.width;
    if (this.#isDense) this.#columns.update(window, gapOf(line));
  }
}

function plainRange(line: LinePoints, { startMs, endMs }: TimeWindow): Range | undefined {
  let [min, max] = [Infinity, -Infinity];
  for (let i = Math.max(0, line.indexAtOrAfter(startMs) - 1); i < line.size; i++) {
    if (line.timeAt(i) > endMs) break;
    const value = line.valueAt(i);
    if (!Number.isFinite(value)) continue;
    if (value < min) min = value;
    if (value > max) max = value;
  }
  return max >= min ? { min, max } : undefined;
}

function tracePlain(
  line: LinePoints,
  { window, toY, isStepped }: TraceOptions,
  sink: PathSink,
): void {
  const { startMs, endMs, width } = window;
  const gapMs = gapOf(line);
  const first = Math.max(0, line.indexAtOrAfter(startMs) - 1);
  const last = Math.min(line.size, line.indexAtOrAfter(endMs) + 1);
  let beforeMs = -Infinity;
  let beforeY: number | undefined;
  for (let i = first; i < last; i++) {
    const timeMs = line.timeAt(i);
    const value = line.valueAt(i);
    if (timeMs - beforeMs > gapMs) beforeY = undefined;
    beforeMs = timeMs;
    if (!Number.isFinite(value)) {
      beforeY = undefined;
      continue;
    }
    const x = ((timeMs - startMs) / (endMs - startMs)) * width;
    const y = toY(value);
    if (beforeY === undefined) {
      sink.moveTo(x, y);
      // A point by itself is seen, too.
      sink.lineTo(x + 0.01, y);
    } else {
      if (isStepped) sink.lineTo(x, beforeY);
      sink.lineTo(x, y);
    }
    beforeY = y;
  }
}

/** From which distance on points are not connected: well beyond what is usual, milliseconds. */
export function gapOf(line: Pick<LinePoints, 'size' | 'timeAt'>): number {
  const gaps: number[] = [];
  for (let i = Math.max(1, line.size - 64); i < line.size; i++) {
    gaps.push(line.timeAt(i) - line.timeAt(i - 1));
  }
  const median = gaps.sort((a, b) => a - b)[gaps.length >> 1] ?? Infinity;
  return Math.max(1000, 8 * median);
}
