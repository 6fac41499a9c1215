import { formatInRange, type NumberRange } from '../values/format-value.ts';
import type { PlotLine } from './plot-line.ts';
import { pointNear, type PlotPoint } from './read-plot.ts';

/** The newest value of a line at one instant. */
export interface LineText extends PlotPoint {
  readonly text: string;
}

/** Returns the newest values of lines at one instant, by key: label, line and legend read the same. */
export function readLines(
  lines: readonly Pick<PlotLine, 'key' | 'points'>[],
  ranges: readonly NumberRange[],
  atMs: number,
): ReadonlyMap<string, LineText> {
  const texts = new Map<string, LineText>();
  for (const [i, { key, points }] of lines.entries()) {
    const point = points && pointNear(points, atMs, atMs);
    const range = ranges[i];
    if (point && range) texts.set(key, { ...point, text: formatInRange(point.value, range) });
  }
  return texts;
}

/** Returns the number of characters that the values of a range take at most. */
export function charactersIn(range: NumberRange): number {
  return Math.max(formatInRange(range.min, range).length, formatInRange(range.max, range).length);
}
