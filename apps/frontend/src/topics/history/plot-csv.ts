import { csvField } from '@ubii/words';
import type { LinePoints } from './series-ring.ts';

/** A column of the CSV. */
export interface CsvColumn {
  readonly name: string;
  readonly points: LinePoints | undefined;
}

/**
 * Exports the visible part of a plot as CSV (RFC 4180), one row for each time at which any line has a point. Empty
 * fields: no point at that time. NaN, Infinity and -Infinity are written as such. Times are ISO 8601 with milliseconds,
 * and epoch milliseconds.
 */
export function plotCsv(columns: readonly CsvColumn[], startMs: number, endMs: number): string {
  const header = ['time', 'time_ms', ...columns.map(({ name }) => csvField(name))];
  const rows = [header.join(',')];
  const next = columns.map(({ points }) => points?.indexAtOrAfter(startMs) ?? 0);
  const timeOf = (column: number): number => {
    const { points } = columns[column]!;
    const index = next[column]!;
    return points && index < points.size ? points.timeAt(index) : Infinity;
  };
  for (;;) {
    let timeMs = Infinity;
    for (let column = 0; column < columns.length; column++) {
      timeMs = Math.min(timeMs, timeOf(column));
    }
    if (timeMs > endMs || timeMs === Infinity) break;
    const fields = columns.map(({ points }, column) => {
      if (timeOf(column) !== timeMs) return '';
      const value = points!.valueAt(next[column]!);
      next[column]! += 1;
      return String(value);
    });
    rows.push([new Date(timeMs).toISOString(), String(roundMs(timeMs)), ...fields].join(','));
  }
  return `${rows.join('\r\n')}\r\n`;
}

/** Rounds to microseconds. */
const roundMs = (timeMs: number): number => Math.round(timeMs * 1000) / 1000;
