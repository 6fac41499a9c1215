import { decode, DATA_FORMATS } from '@ubii/proto';

import type { RecordsQuery, RecordsReader } from '../reading/recording-reader.ts';
import { describeRecord, type RecordedRecord } from '../records/recorded-record.ts';

/** A number, truth value or text of a table; undefined where a record has none. */
export type Cell = number | boolean | string | undefined;

/**
 * The leaves of a decoded value with their paths: `x` of a vector, `0.x` of the first vector of a list (the member
 * `elements` is left out), `value` of a single number or text. Of bytes, such as pixels, only the length is given, as
 * `data.byteLength`.
 *
 * @param visit is called for each leaf, in the order of the members
 */
export function flattenValue(value: unknown, visit: (path: string, cell: Cell) => void): void {
  flatten(value, '', visit);
}

function flatten(value: unknown, path: string, visit: (path: string, cell: Cell) => void): void {
  if (value === undefined || value === null) return;
  if (value instanceof Uint8Array) return visit(join(path, 'byteLength'), value.byteLength);
  if (typeof value !== 'object') {
    const isPlain = ['number', 'boolean', 'string'].includes(typeof value);
    return visit(path === '' ? 'value' : path, isPlain ? (value as Cell) : String(value));
  }
  for (const [member, child] of Object.entries(value)) {
    flatten(child, member === 'elements' ? path : join(path, member), visit);
  }
}

function join(path: string, member: string): string {
  return path === '' ? member : `${path}.${member}`;
}

/** Columns of one table; elements of a longer list are left out and reported. */
const MAX_COLUMNS = 1024;

export interface TableColumn {
  /** Path of the member, such as `position.x`. */
  readonly name: string;
  /** Values of several types in one column are texts. */
  readonly type: 'number' | 'boolean' | 'string';
}

/** One record as a row. */
export interface TableRow {
  /** Nanoseconds since the Unix epoch, as in `RecordedRecord`. */
  readonly publishTimeNs: bigint;
  readonly logTimeNs: bigint;
  readonly clientId: string;
  /** Data format of the value; empty for a record without one. */
  readonly format: string;
  /** In the order of the columns. */
  readonly cells: readonly Cell[];
}

/** The records of a topic as a table. */
export interface TopicTable {
  readonly topic: string;
  readonly columns: readonly TableColumn[];
  /** Members beyond the 1024 columns. */
  readonly leftOutColumns: number;
  /** Reads the rows, oldest first. */
  rows(): AsyncIterable<TableRow>;
}

/** How a table is read. */
export interface TableOptions extends Omit<RecordsQuery, 'topics' | 'isReverse'> {
  /** Only records of this client; default: of all. */
  readonly clientId?: string;
  readonly signal?: { throwIfAborted(): void };
  /** Told now and then: records read so far, in both passes. */
  readonly onProgress?: (records: number) => void;
}

/** Records between two messages of progress. */
const PROGRESS_RECORDS = 1000;

/**
 * Reads a topic once to find its columns. The rows are read a second time, so that no more than one of them is in memory.
 *
 * @throws the reason of `options.signal` when it is aborted
 */
export async function topicTable(
  reader: RecordsReader,
  topic: string,
  options: TableOptions = {},
): Promise<TopicTable> {
  const read = countedRecords(reader, topic, options);
  const types = new Map<string, TableColumn['type']>();
  const leftOut = new Set<string>();
  for await (const record of read()) {
    eachCell(record, (path, cell) => {
      const type = typeof cell as TableColumn['type'];
      const known = types.get(path);
      if (known === undefined && types.size >= MAX_COLUMNS) leftOut.add(path);
      else types.set(path, known === undefined || known === type ? type : 'string');
    });
  }
  const columns = [...types].map(([name, type]) => ({ name, type }));
  const places = new Map(columns.map(({ name }, place) => [name, place]));
  return {
    topic,
    columns,
    leftOutColumns: leftOut.size,
    async *rows() {
      for await (const record of read()) {
        const cells = new Array<Cell>(columns.length).fill(undefined);
        eachCell(record, (path, cell) => {
          const place = places.get(path);
          if (place !== undefined) cells[place] = typed(cell, columns[place]!.type);
        });
        const { publishTimeNs, logTimeNs, clientId } = record;
        const format = describeRecord(record.record).format ?? '';
        yield { publishTimeNs, logTimeNs, clientId, format, cells };
      }
    },
  };
}

function countedRecords(
  reader: RecordsReader,
  topic: string,
  { clientId, signal, onProgress, ...span }: TableOptions,
): () => AsyncIterable<RecordedRecord> {
  let count = 0;
  return async function* () {
    for await (const record of reader.records({ ...span, topics: [topic] })) {
      signal?.throwIfAborted();
      if (clientId !== undefined && record.clientId !== clientId) continue;
      if (++count % PROGRESS_RECORDS === 0) onProgress?.(count);
      yield record;
    }
  };
}

function typed(cell: Cell, type: TableColumn['type']): Cell {
  return type === 'string' && cell !== undefined ? String(cell) : cell;
}

/** Records without a value, of other programs, or with bytes that cannot be decoded are rows without cells. */
function eachCell({ record }: RecordedRecord, visit: (path: string, cell: Cell) => void): void {
  const { format } = describeRecord(record);
  if (format === undefined || !Object.hasOwn(DATA_FORMATS, format)) return;
  let value: unknown;
  try {
    value = decode('ubii.topicData.TopicDataRecord', record)[format];
  } catch {
    return;
  }
  flattenValue(value, visit);
}
