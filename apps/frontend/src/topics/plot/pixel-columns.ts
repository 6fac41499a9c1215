import type { LinePoints } from '../history/series-ring.ts';
import type { PathSink, TimeWindow, TraceOptions } from './trace-options.ts';
import type { NumberRange } from '../values/format-value.ts';

/** Number of columns beyond each end of the window. */
const SPARE = 4;

/**
 * First, lowest, highest and last value of each pixel column of a window. When the window advances with time, only new
 * points are processed; any other change processes the whole window.
 */
export class PixelColumns {
  readonly #line: LinePoints;
  /** Duration of a column. */
  #columnMs = 0;
  #gapMs = 0;
  /** Indices of the first and last column of the window. */
  #from = 0;
  #to = -1;
  /** Number of the next point to process, in terms of `pushed`. */
  #nextPoint = 0;
  #beforeMs = -Infinity;
  /** True when the previous point was not a number. */
  #isOpen = true;
  /** Index of the column stored at each place, followed by its values. */
  #ids = new Float64Array(0);
  #first = new Float64Array(0);
  #min = new Float64Array(0);
  #max = new Float64Array(0);
  #last = new Float64Array(0);
  /** 1 when it is not connected to the previous column. */
  #isCut = new Uint8Array(0);

  constructor(line: LinePoints) {
    this.#line = line;
  }

  update({ startMs, endMs, width }: TimeWindow, gapMs: number): void {
    const columnMs = (endMs - startMs) / width;
    const from = Math.floor(startMs / columnMs);
    const isSame = Math.abs(columnMs / this.#columnMs - 1) < 1e-9 && from >= this.#from;
    // The usual gap of a topic varies slightly, which needs no restart.
    const isUsual = gapMs > this.#gapMs / 2 && gapMs < this.#gapMs * 2;
    const places = Math.ceil(width) + 2 * SPARE;
    const isKept = isSame && isUsual && places === this.#ids.length;
    if (!isKept || from > this.#to) this.#restart(columnMs, gapMs, places, startMs);
    this.#from = from;
    this.#to = Math.ceil(endMs / this.#columnMs);
    this.#count();
  }

  range(): NumberRange | undefined {
    let [min, max] = [Infinity, -Infinity];
    for (let column = this.#from; column <= this.#to; column++) {
      const place = this.#placeOf(column);
      if (this.#ids[place] !== column) continue;
      if (this.#min[place]! < min) min = this.#min[place]!;
      if (this.#max[place]! > max) max = this.#max[place]!;
    }
    return max >= min ? { min, max } : undefined;
  }

  trace({ window: { startMs }, toY }: TraceOptions, sink: PathSink): void {
    let isDown = false;
    for (let column = this.#from; column <= this.#to; column++) {
      const place = this.#placeOf(column);
      if (this.#ids[place] !== column) continue;
      const x = column - startMs / this.#columnMs;
      const first = toY(this.#first[place]!);
      if (isDown && this.#isCut[place] === 0) sink.lineTo(x, first);
      else sink.moveTo(x, first);
      isDown = true;
      if (this.#min[place] !== this.#max[place]) {
        sink.lineTo(x, toY(this.#min[place]!));
        sink.lineTo(x, toY(this.#max[place]!));
      }
      sink.lineTo(x + 0.01, toY(this.#last[place]!));
    }
  }

  #restart(columnMs: number, gapMs: number, places: number, startMs: number): void {
    this.#columnMs = columnMs;
    this.#gapMs = gapMs;
    if (places !== this.#ids.length) {
      this.#ids = new Float64Array(places);
      this.#first = new Float64Array(places);
      this.#min = new Float64Array(places);
      this.#max = new Float64Array(places);
      this.#last = new Float64Array(places);
      this.#isCut = new Uint8Array(places);
    }
    this.#ids.fill(Number.NaN);
    const line = this.#line;
    const index = Math.max(0, line.indexAtOrAfter(startMs) - 1);
    this.#nextPoint = line.pushed - line.size + index;
    this.#beforeMs = -Infinity;
    this.#isOpen = true;
  }

  /** Processes new points up to the end of the window. */
  #count(): void {
    const line = this.#line;
    const oldest = line.pushed - line.size;
    for (let point = Math.max(this.#nextPoint, oldest); point < line.pushed; point++) {
      const index = point - oldest;
      const timeMs = line.timeAt(index);
      const column = Math.floor(timeMs / this.#columnMs);
      if (column > this.#to) break;
      this.#nextPoint = point + 1;
      const value = line.valueAt(index);
      if (timeMs - this.#beforeMs > this.#gapMs) this.#isOpen = true;
      this.#beforeMs = timeMs;
      if (!Number.isFinite(value)) this.#isOpen = true;
      else if (column >= this.#from) this.#add(column, value);
    }
  }

  #add(column: number, value: number): void {
    const place = this.#placeOf(column);
    if (this.#ids[place] !== column) {
      this.#ids[place] = column;
      this.#first[place] = this.#min[place] = this.#max[place] = value;
      this.#isCut[place] = this.#isOpen ? 1 : 0;
    } else {
      if (value < this.#min[place]!) this.#min[place] = value;
      if (value > this.#max[place]!) this.#max[place] = value;
    }
    this.#last[place] = value;
    this.#isOpen = false;
  }

  #placeOf(column: number): number {
    return column % this.#ids.length;
  }
}
