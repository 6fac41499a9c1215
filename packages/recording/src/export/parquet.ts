import { ByteWriter, parquetWriteRows, type Writer } from 'hyparquet-writer';
import type { TableColumn, TopicTable } from './topic-table.ts';

const PARQUET_TYPES = { number: 'DOUBLE', boolean: 'BOOLEAN', string: 'STRING' } as const;

/** Names of the columns before those of the value; a member of the same name gets the prefix `value.`. */
const FIXED = [
  { name: 'publish_time_ns', type: 'INT64' },
  { name: 'log_time_ns', type: 'INT64' },
  { name: 'publisher', type: 'STRING' },
] as const;

/** Rows in memory at once. */
const ROWS_PER_GROUP = 20_000;

/** Passes the written bytes on after each group of rows. */
function partWriter(write: (bytes: Uint8Array) => Promise<void> | void): Writer {
  const bytes = new ByteWriter();
  const flush = async (): Promise<void> => {
    const part = bytes.getBytes().slice();
    // The place in the buffer; `offset`, the place in the file, counts on.
    bytes.index = 0;
    if (part.byteLength > 0) await write(part);
  };
  return Object.assign(bytes, { flush, finish: flush });
}

/**
 * Writes a table as Parquet (Snappy, groups of 20 000 rows): `publish_time_ns` and `log_time_ns` in nanoseconds since the
 * Unix epoch, `publisher`, then the columns, where numbers are doubles. Cells that a record does not have are null.
 *
 * @param write receives the file in parts, in order
 * @param nameOf name of a client, by its id
 * @throws the reason of the signal of the table, and the error of `write`
 */
export async function writeParquet(
  table: TopicTable,
  write: (bytes: Uint8Array) => Promise<void> | void,
  nameOf: (clientId: string) => string = (clientId) => clientId,
): Promise<void> {
  const columns = table.columns.map((column) => ({
    name: columnName(column),
    type: PARQUET_TYPES[column.type],
  }));
  await parquetWriteRows({
    writer: partWriter(write),
    columns: [...FIXED, ...columns],
    rows: rowsOf(table, nameOf),
    rowGroupSize: ROWS_PER_GROUP,
    kvMetadata: [{ key: 'topic', value: table.topic }],
    createdBy: 'ubi-interact',
  });
}

async function* rowsOf(
  table: TopicTable,
  nameOf: (clientId: string) => string,
): AsyncGenerator<Record<string, unknown>> {
  const names = table.columns.map(columnName);
  for await (const { publishTimeNs, logTimeNs, clientId, cells } of table.rows()) {
    yield {
      publish_time_ns: publishTimeNs,
      log_time_ns: logTimeNs,
      publisher: nameOf(clientId),
      ...Object.fromEntries(names.map((name, place) => [name, cells[place]])),
    };
  }
}

function columnName({ name }: TableColumn): string {
  return FIXED.some((fixed) => fixed.name === name) ? `value.${name}` : name;
}
