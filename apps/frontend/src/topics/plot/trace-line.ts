import type { SeriesRing } from '../history/series-ring.ts';

/** What a line is drawn on; a canvas or a Path2D is one. */
export interface PathSink {
  moveTo(x: number, y: number): void;
  lineTo(x: number, y: number): void;
}

/** The part of the time axis that is drawn. */
export interface TimeWindow {
  readonly startMs: number;
  readonly endMs: number;
  /** Pixels. */
  readonly width: number;
}

export interface TraceOptions {
  readonly window: TimeWindow;
  readonly toY: (value: number) => number;
  /** Points further apart than this are not connected, milliseconds. */
  readonly gapMs: number;
  /** A value holds until the next one, as with bool. */
  readonly isStepped: boolean;
}

/** Points for each pixel from which on only the extremes of a pixel are drawn. */
const DENSE = 3;

/**
 * Draws one line of the points, with one point beyond each end of the window. Where points are dense
 * it draws the lowest and the highest of each pixel, so that no peak is lost and time stays bounded.
 */
export function traceLine(
  ring: SeriesRing,
  line: number,
  options: TraceOptions,
  sink: PathSink,
): void {
  const { window, gapMs } = options;
  const first = Math.max(0, ring.indexAtOrAfter(window.startMs) - 1);
  const last = Math.min(ring.size, ring.indexAtOrAfter(window.endMs) + 1);
  const isDense = last - first > DENSE * window.width;
  const pen = isDense ? new DensePen(options, sink) : new PlainPen(options, sink);
  let beforeMs = -Infinity;
  for (let i = first; i < last; i++) {
    const timeMs = ring.timeAt(i);
    const value = ring.valueAt(line, i);
    if (!Number.isFinite(value) || timeMs - beforeMs > gapMs) pen.lift();
    if (Number.isFinite(value)) pen.draw(timeMs, value);
    beforeMs = timeMs;
  }
  pen.lift();
}

const toX = ({ startMs, endMs, width }: TimeWindow, timeMs: number): number =>
  ((timeMs - startMs) / (endMs - startMs)) * width;

class PlainPen {
  readonly #options: TraceOptions;
  readonly #sink: PathSink;
  #beforeY: number | undefined;

  constructor(options: TraceOptions, sink: PathSink) {
    this.#options = options;
    this.#sink = sink;
  }

  draw(timeMs: number, value: number): void {
    const x = toX(this.#options.window, timeMs);
    const y = this.#options.toY(value);
    if (this.#beforeY === undefined) this.#sink.moveTo(x, y);
    else {
      if (this.#options.isStepped) this.#sink.lineTo(x, this.#beforeY);
      this.#sink.lineTo(x, y);
    }
    this.#beforeY = y;
  }

  lift(): void {
    this.#beforeY = undefined;
  }
}

class DensePen {
  readonly #options: TraceOptions;
  readonly #sink: PathSink;
  #column: { x: number; first: number; min: number; max: number; last: number } | undefined;
  #isDown = false;

  constructor(options: TraceOptions, sink: PathSink) {
    this.#options = options;
    this.#sink = sink;
  }

  draw(timeMs: number, value: number): void {
    const x = Math.floor(toX(this.#options.window, timeMs));
    const column = this.#column;
    if (column?.x === x) {
      column.min = Math.min(column.min, value);
      column.max = Math.max(column.max, value);
      column.last = value;
      return;
    }
    this.#flush();
    this.#column = { x, first: value, min: value, max: value, last: value };
  }

  lift(): void {
    this.#flush();
    this.#isDown = false;
  }

  #flush(): void {
    const column = this.#column;
    if (column === undefined) return;
    this.#column = undefined;
    const { x, first, min, max, last } = column;
    const { toY } = this.#options;
    if (this.#isDown) this.#sink.lineTo(x, toY(first));
    else this.#sink.moveTo(x, toY(first));
    this.#isDown = true;
    if (min === max) return;
    this.#sink.lineTo(x, toY(min));
    this.#sink.lineTo(x, toY(max));
    this.#sink.lineTo(x, toY(last));
  }
}

/** From which distance on points are not connected: well beyond what is usual, milliseconds. */
export function gapOf(ring: SeriesRing): number {
  const gaps: number[] = [];
  for (let i = Math.max(1, ring.size - 64); i < ring.size; i++) {
    gaps.push(ring.timeAt(i) - ring.timeAt(i - 1));
  }
  const median = gaps.sort((a, b) => a - b)[gaps.length >> 1] ?? Infinity;
  return Math.max(1000, 8 * median);
}
