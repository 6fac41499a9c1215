import { csvField } from '@ubii/words';
import { plotCsv } from './plot-csv.ts';
import type { TopicHistory } from './topic-history.ts';

/**
 * Exports the history of a topic as CSV, oldest first (RFC 4180): each point of numeric values, otherwise the records
 * as text, with both times in epoch milliseconds.
 */
export function historyCsv(history: TopicHistory): string {
  const { points, series, records } = history;
  if (points && series && points.size > 0) {
    const columns = series.names.map((name, line) => ({
      name,
      points: history.lineOf(series.paths[line]!),
    }));
    return plotCsv(columns, -Infinity, Infinity);
  }
  const rows = ['time,time_ms,arrived,arrived_ms,value'];
  for (let number = records.firstNumber; number <= records.count; number++) {
    const line = history.lineAt(number);
    if (!line) continue;
    const { timeMs, arrivalMs, text } = line;
    const times = [timeMs, arrivalMs].flatMap((ms) => [new Date(ms).toISOString(), String(ms)]);
    rows.push([...times, csvField(text)].join(','));
  }
  return `${rows.join('\r\n')}\r\n`;
}

/** Filename of the table of a topic. */
export function csvName(topic: string): string {
  return `${fileNameOf(topic)}.csv`;
}

/** Converts a topic to a filename without extension. */
export function fileNameOf(topic: string): string {
  return topic.replace(/^\/+/, '').replace(/[^\w.-]+/g, '-') || 'topic';
}
