import { csvText } from './csv-text.ts';
import type { LinePoints } from './series-ring.ts';

/** A column of the table. */
export interface CsvColumn {
  readonly name: string;
  readonly points: LinePoints | undefined;
}

/**
 * What a window shows as a table (RFC 4180), one row for each moment at which any line has a point.
 * An empty field: the line has no point then. What is no number is written as NaN, Infinity or
 * -Infinity. Times are ISO 8601 with milliseconds, and milliseconds since the Unix epoch.
 */
export function plotCsv(columns: readonly CsvColumn[], startMs: number, endMs: number): string {
  const header = ['time', 'time_ms', ...columns.map(({ name }) => csvText(name))];
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

/** Microseconds are enough. */
const roundMs = (timeMs: number): number => Math.round(timeMs * 1000) / 1000;
