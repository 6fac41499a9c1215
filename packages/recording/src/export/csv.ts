import { csvField } from '@ubii/words';
import type { TopicTable } from './topic-table.ts';
import { decimalMs, isoTime } from './times.ts';

/** Length of the parts that are given out, characters. */
const PART_LENGTH = 64 * 1024;

/**
 * A table as CSV (RFC 4180), in parts: the time of the value and of its arrival, as ISO 8601 and in milliseconds since
 * the Unix epoch, the publisher, then the columns. Texts that spreadsheets take for formulas begin with `'`.
 *
 * @param nameOf name of a client, by its id
 */
export async function* csvOf(
  table: TopicTable,
  nameOf: (clientId: string) => string = (clientId) => clientId,
): AsyncGenerator<string> {
  const names = table.columns.map(({ name }) => csvField(name));
  let part = `${['time', 'time_ms', 'arrived', 'arrived_ms', 'publisher', ...names].join(',')}\r\n`;
  for await (const { publishTimeNs, logTimeNs, clientId, cells } of table.rows()) {
    const times = [publishTimeNs, logTimeNs].flatMap((time) => [isoTime(time), decimalMs(time)]);
    const values = cells.map((cell) => (typeof cell === 'string' ? csvField(cell) : (cell ?? '')));
    part += `${[...times, csvField(nameOf(clientId)), ...values].join(',')}\r\n`;
    if (part.length < PART_LENGTH) continue;
    yield part;
    part = '';
  }
  if (part !== '') yield part;
}
