import { csvField } from '@ubii/words';

import type { TopicTable } from './topic-table.ts';

/** A time as ISO 8601 with nine decimals, UTC. @param timeNs nanoseconds since the Unix epoch */
function isoTime(timeNs: bigint): string {
  const [seconds] = new Date(Number(timeNs / 1_000_000n)).toISOString().split('.');
  return `${seconds}.${String(timeNs % 1_000_000_000n).padStart(9, '0')}Z`;
}

/** A time in milliseconds since the Unix epoch, with the decimals that it has. */
function decimalMs(timeNs: bigint): string {
  const decimals = String(timeNs % 1_000_000n)
    .padStart(6, '0')
    .replace(/0+$/, '');
  return `${timeNs / 1_000_000n}${decimals === '' ? '' : `.${decimals}`}`;
}

/** Columns before those of the value. */
export const CSV_HEAD = [
  ...['time', 'time_ms', 'arrived', 'arrived_ms', 'publisher', 'topic', 'format'],
] as const;

/** Length of the parts that are given out, characters. */
const PART_LENGTH = 64 * 1024;

/**
 * A table as CSV (RFC 4180), in parts: the time of the value and of its arrival, as ISO 8601 and in milliseconds since
 * the Unix epoch, publisher, topic and data format, then the columns. Texts that spreadsheets take for formulas begin
 * with `'`. `importCsv` reads it.
 *
 * @param nameOf name of a client, by its id
 */
export async function* csvOf(
  table: TopicTable,
  nameOf: (clientId: string) => string = (clientId) => clientId,
): AsyncGenerator<string> {
  const names = table.columns.map(({ name }) => csvField(name));
  let part = `${[...CSV_HEAD, ...names].join(',')}\r\n`;
  const topic = csvField(table.topic);
  for await (const { publishTimeNs, logTimeNs, clientId, format, cells } of table.rows()) {
    const times = [publishTimeNs, logTimeNs].flatMap((time) => [isoTime(time), decimalMs(time)]);
    const values = cells.map((cell) => (typeof cell === 'string' ? csvField(cell) : (cell ?? '')));
    part += `${[...times, csvField(nameOf(clientId)), topic, format, ...values].join(',')}\r\n`;
    if (part.length < PART_LENGTH) continue;
    yield part;
    part = '';
  }
  if (part !== '') yield part;
}
