/** A measurement: at `time` by the clock of the stream, `offset` is added to it. Seconds. */
export interface ClockOffset {
  readonly time: number;
  readonly offset: number;
}

/** Offsets between two resets of a clock, as a line. */
interface Segment {
  readonly intercept: number;
  readonly slope: number;
  /** Times of its first and last measurement. */
  readonly from: number;
  readonly until: number;
}

/**
 * Brings times of a stream to those of the recorder, as `pyxdf` 1.17 does (functions `_clock_sync`,
 * `_detect_clock_resets` and `_robust_fit`): a line through the offsets that outliers move little, one for each stretch
 * between two resets of the clock. Times are given in order.
 */
export class ClockFit {
  readonly #segments: readonly Segment[];
  #current = 0;

  constructor(offsets: readonly ClockOffset[]) {
    this.#segments = split(offsets).map(fit);
  }

  /** @param time by the clock of the stream, seconds, not before the one of the call before */
  correct(time: number): number {
    let segment = this.#segments[this.#current];
    if (segment === undefined) return time;
    for (
      let next = this.#segments[this.#current + 1];
      next !== undefined && Math.abs(time - segment.until) >= Math.abs(time - next.from);
      next = this.#segments[this.#current + 1]
    ) {
      segment = next;
      this.#current++;
    }
    return time + (segment.intercept + segment.slope * time);
  }
}

const RESET = { timeStds: 5, timeSeconds: 5, offsetStds: 10, offsetSeconds: 1 } as const;

function split(offsets: readonly ClockOffset[]): ClockOffset[][] {
  if (offsets.length === 0) return [];
  const times = differences(offsets.map(({ time }) => time));
  const values = differences(offsets.map(({ offset }) => offset));
  const timeBreaks = outliers(times, RESET.timeStds, RESET.timeSeconds);
  const valueBreaks = outliers(values, RESET.offsetStds, RESET.offsetSeconds);
  const segments: ClockOffset[][] = [[offsets[0]!]];
  for (const [i, difference] of times.entries()) {
    if (difference < 0 || (timeBreaks[i]! && valueBreaks[i]!)) segments.push([]);
    segments.at(-1)!.push(offsets[i + 1]!);
  }
  return segments;
}

function differences(values: readonly number[]): number[] {
  return values.slice(1).map((value, i) => value - values[i]!);
}

function outliers(values: readonly number[], stds: number, seconds: number): boolean[] {
  const middle = median(values);
  const distances = values.map((value) => Math.abs(value - middle));
  const deviation = median(distances) + Number.EPSILON;
  return distances.map((distance) => distance / deviation > stds && distance > seconds);
}

function median(values: readonly number[]): number {
  const sorted = [...values].sort((a, b) => a - b);
  const half = Math.floor(sorted.length / 2);
  if (sorted.length % 2 === 1) return sorted[half]!;
  return sorted.length === 0 ? 0 : (sorted[half - 1]! + sorted[half]!) / 2;
}

/** Offsets closer to the line than this count fully, seconds. */
const WINSOR = 0.0001;
const ITERATIONS = 1000;

/** Linear regression by the loss function of Huber, solved by the alternating direction method of multipliers. */
function fit(offsets: readonly ClockOffset[]): Segment {
  const [from, until] = [offsets[0]!.time, offsets.at(-1)!.time];
  if (offsets.length === 1) return { intercept: offsets[0]!.offset, slope: 0, from, until };
  const first = offsets.reduce((least, { time }) => Math.min(least, time), Infinity) / WINSOR;
  const a = offsets.map(({ time }) => time / WINSOR - first);
  const y = offsets.map(({ offset }) => offset / WINSOR);
  // The upper triangle of the decomposition of Cholesky: rows (r11, r12) and (0, r22).
  const r11 = Math.sqrt(a.length);
  const r12 = sum(a) / r11;
  const r22 = Math.sqrt(sum(a.map((one) => one * one)) - r12 * r12);
  // All were measured at the same time.
  if (!(r22 > 0)) return { intercept: 0, slope: 0, from, until };
  const target = y.slice();
  const u = y.map(() => 0);
  let [x0, x1] = [0, 0];
  for (let k = 0; k < ITERATIONS; k++) {
    const [b0, b1] = [sum(target), sum(target.map((one, i) => one * a[i]!))];
    const w0 = b0 / r11;
    x1 = (b1 - r12 * w0) / r22 / r22;
    x0 = (w0 - r12 * x1) / r11;
    for (let i = 0; i < a.length; i++) {
      const d = x0 + x1 * a[i]! - y[i]! + u[i]!;
      const kept = d === 0 ? 1 : Math.max(0, 1 - 2 / Math.abs(d));
      const z = d / 2 + (kept * d) / 2;
      u[i] = d - z;
      target[i] = y[i]! + z - u[i]!;
    }
  }
  return { intercept: (x0 - x1 * first) * WINSOR, slope: x1, from, until };
}

function sum(values: readonly number[]): number {
  return values.reduce((total, value) => total + value, 0);
}
