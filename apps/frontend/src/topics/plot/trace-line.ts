import type { LinePoints } from '../history/series-ring.ts';
import { PixelColumns } from './pixel-columns.ts';
import type { PathSink, TimeWindow, TraceOptions } from './trace-options.ts';
import type { NumberRange } from '../values/format-value.ts';

/** Points per pixel from which only the extremes of each pixel are drawn. */
const DENSE = 3;

/**
 * Draws a line repeatedly. Where points are dense, draws the lowest and highest value of each pixel, so that no peak is
 * lost and the cost depends on pixels instead of points. Values per pixel are kept while the window advances.
 */
export class TracedLine {
  readonly line: LinePoints;
  readonly #columns: PixelColumns;
  #isDense = false;

  constructor(line: LinePoints) {
    this.line = line;
    this.#columns = new PixelColumns(line);
  }

  /** Returns the range of values in a window, including the previous value, which holds into it. */
  rangeIn(window: TimeWindow): NumberRange | undefined {
    this.#look(window);
    return this.#isDense ? this.#columns.range() : plainRange(this.line, window);
  }

  /** Includes one point beyond each end of the window. Leaves gaps where values are missing or not numbers. */
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

function plainRange(line: LinePoints, { startMs, endMs }: TimeWindow): NumberRange | undefined {
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
      // Makes an isolated point visible.
      sink.lineTo(x + 0.01, y);
    } else {
      if (isStepped) sink.lineTo(x, beforeY);
      sink.lineTo(x, y);
    }
    beforeY = y;
  }
}

/** Returns the distance from which points are not connected: well above the usual one, milliseconds. */
export function gapOf(line: Pick<LinePoints, 'size' | 'timeAt'>): number {
  const gaps: number[] = [];
  for (let i = Math.max(1, line.size - 64); i < line.size; i++) {
    gaps.push(line.timeAt(i) - line.timeAt(i - 1));
  }
  const median = gaps.sort((a, b) => a - b)[gaps.length >> 1] ?? Infinity;
  return Math.max(1000, 8 * median);
}
