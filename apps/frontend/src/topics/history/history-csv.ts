import type { TopicHistory } from './topic-history.ts';

/**
 * What is kept of a topic as a table, oldest first: every point of values that are numbers, else the
 * newest records by their one line. Times are milliseconds since the Unix epoch. (RFC 4180)
 */
export function historyCsv(history: TopicHistory): string {
  const { points, series } = history;
  const rows: (readonly (string | number)[])[] = [];
  if (points && series && points.size > 0) {
    rows.push(['time', 'time_ms', ...series.names]);
    for (let index = 0; index < points.size; index++) {
      const timeMs = points.timeAt(index);
      const values = series.names.map((_name, line) => points.valueAt(line, index));
      rows.push([new Date(timeMs).toISOString(), timeMs, ...values]);
    }
  } else {
    rows.push(['time', 'time_ms', 'value']);
    for (const { timeMs, text } of history.lines().reverse()) {
      rows.push([new Date(timeMs).toISOString(), timeMs, text]);
    }
  }
  return `${rows.map((row) => row.map(csvField).join(',')).join('\r\n')}\r\n`;
}

/** The name of the file with the table of a topic. */
export function csvName(topic: string): string {
  return `${fileNameOf(topic)}.csv`;
}

/** A topic as the name of a file, without its ending. */
export function fileNameOf(topic: string): string {
  return topic.replace(/^\/+/, '').replace(/[^\w.-]+/g, '-') || 'topic';
}

function csvField(value: string | number): string {
  if (typeof value === 'number') return Number.isFinite(value) ? String(value) : '';
  // What spreadsheets take for a formula is made a text.
  const text = /^[=+@\t\r-]/.test(value) ? `'${value}` : value;
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}
