import type { DataFormat } from '@ubii/proto';
import { CSV_HEAD } from '../../export/csv.ts';
import { RecordingError } from '../../records/recording-error.ts';
import type { BufferedSource } from '../buffered-source.ts';
import { hasPaths } from '../value-from-paths.ts';
import { csvRows, delimiterOf, type CsvRow, type Delimiter } from './csv-rows.ts';
import { isTimeName, unitOf, type TimeUnit } from './csv-time.ts';

/** How a table becomes topics. What is not given is found out. */
export interface CsvOptions {
  /** Name of the column with the times. */
  readonly timeColumn?: string | undefined;
  readonly timeUnit?: TimeUnit | undefined;
  /** A topic for each column, or one for all numbers of a row. @default `topics` */
  readonly layout?: 'topics' | 'object' | undefined;
  /** Topic of the rows, and level above those of the columns. @default the name of the recording */
  readonly topic?: string | undefined;
  /** Topics that are imported. @default all */
  readonly topics?: readonly string[] | undefined;
}

export interface CsvColumn {
  readonly name: string;
  /** Place in the row. */
  readonly place: number;
  readonly type: 'number' | 'bool' | 'string';
}

/** A topic that columns become. */
export interface CsvTopic {
  readonly topic: string;
  readonly format: DataFormat;
  readonly columns: readonly CsvColumn[];
}

/** How a file will be read. */
export interface CsvPlan {
  readonly delimiter: Delimiter;
  /** The file is an export of a recording, with topic and format of each row. */
  readonly isExport: boolean;
  readonly names: readonly string[];
  /** Undefined when no column has times. */
  readonly time: { readonly place: number; readonly unit: TimeUnit } | undefined;
  /** Of an export: those of its first rows. */
  readonly topics: readonly CsvTopic[];
}

const SAMPLE_ROWS = 200;
const MAX_COLUMNS = 1024;

/** Reads the beginning of a table. @throws RecordingError when it is none */
export async function planCsv(
  source: BufferedSource,
  name: string,
  options: CsvOptions,
): Promise<CsvPlan> {
  const delimiter = await delimiterOf(source);
  const rows: CsvRow[] = [];
  for await (const row of csvRows(source, delimiter)) {
    rows.push(row);
    if (rows.length > SAMPLE_ROWS) break;
  }
  const [header, ...samples] = rows;
  if (header === undefined) throw new RecordingError('The file is empty.');
  if (samples.length === 0) throw new RecordingError('The table has a header and no rows.');
  if (header.cells.length > MAX_COLUMNS) {
    throw new RecordingError(`The table has more than ${MAX_COLUMNS} columns.`);
  }
  const names = uniqueNames(header.cells);
  const cellsOf = (place: number): string[] => samples.map(({ cells }) => cells[place] ?? '');
  if (CSV_HEAD.every((head, place) => names[place] === head)) {
    const topics = topicsOfExport(samples);
    return { delimiter, isExport: true, names, time: { place: 0, unit: 'iso' }, topics };
  }
  const time = timeOf(names, cellsOf, options);
  const columns = names
    .map((name, place) => ({ name, place, type: typeOf(cellsOf(place), delimiter) }))
    .filter(({ place }) => place !== time?.place);
  const base = options.topic || `/${levelOf(name) || 'table'}`;
  const topics = topicsOf(columns, base, options.layout ?? 'topics');
  return { delimiter, isExport: false, names, time, topics };
}

function uniqueNames(cells: readonly string[]): string[] {
  const taken = new Map<string, number>();
  return cells.map((cell, place) => {
    const name = cell.trim() || `column ${place + 1}`;
    const count = (taken.get(name) ?? 0) + 1;
    taken.set(name, count);
    return count === 1 ? name : `${name} (${count})`;
  });
}

function topicsOfExport(samples: readonly CsvRow[]): CsvTopic[] {
  const [topicAt, formatAt] = [CSV_HEAD.indexOf('topic'), CSV_HEAD.indexOf('format')];
  const topics = new Map<string, CsvTopic>();
  for (const { cells } of samples) {
    const [topic = '', format = ''] = [cells[topicAt], cells[formatAt]];
    topics.set(topic, { topic, format: format as DataFormat, columns: [] });
  }
  return [...topics.values()];
}

function timeOf(
  names: readonly string[],
  cellsOf: (place: number) => string[],
  { timeColumn, timeUnit }: CsvOptions,
): CsvPlan['time'] {
  const unitAt = (place: number): TimeUnit | undefined =>
    timeUnit ?? unitOf(names[place]!, cellsOf(place));
  if (timeColumn !== undefined) {
    const place = names.indexOf(timeColumn);
    if (place < 0) {
      throw new RecordingError(
        `There is no column "${timeColumn}". Columns are ${names.map((name) => `"${name}"`).join(', ')}.`,
      );
    }
    return { place, unit: unitAt(place) ?? 's' };
  }
  const places = [...names.keys()];
  const place =
    places.find((one) => isTimeName(names[one]!) && unitAt(one) !== undefined) ??
    places.find((one) => unitOf(names[one]!, cellsOf(one)) === 'iso');
  return place === undefined ? undefined : { place, unit: unitAt(place)! };
}

function typeOf(cells: readonly string[], delimiter: Delimiter): CsvColumn['type'] {
  const known = cells.filter((cell) => !isMissing(cell));
  if (known.length === 0) return 'string';
  if (known.every((cell) => /^(true|false)$/i.test(cell.trim()))) return 'bool';
  return known.every((cell) => numberIn(cell, delimiter) !== undefined) ? 'number' : 'string';
}

const MISSING = new Set(['', 'na', 'n/a', 'null', 'none']);

/** Whether a cell says that there is no value. */
export const isMissing = (cell: string): boolean => MISSING.has(cell.trim().toLowerCase());

/** The number in a cell. In tables that are separated by `;`, it may have a decimal comma. */
export function numberIn(cell: string, delimiter: Delimiter): number | undefined {
  const text = delimiter === ';' ? cell.trim().replace(',', '.') : cell.trim();
  if (/^[+-]?nan$/i.test(text)) return NaN;
  if (/^[+-]?inf(inity)?$/i.test(text)) return text.startsWith('-') ? -Infinity : Infinity;
  const number = text === '' ? NaN : Number(text);
  return Number.isNaN(number) ? undefined : number;
}

/** Formats of rows that are told by the names of their columns. */
const ROW_FORMATS = [
  ...['vector2', 'vector3', 'vector4', 'color', 'pose2D', 'pose3D', 'matrix3x2', 'matrix4x4'],
] as const satisfies readonly DataFormat[];

function topicsOf(
  columns: readonly CsvColumn[],
  base: string,
  layout: 'topics' | 'object',
): CsvTopic[] {
  const numbers = columns.filter(({ type }) => type === 'number');
  if (layout === 'topics' || numbers.length === 0) return columns.map((one) => ofColumn(one, base));
  const paths = numbers.map(({ name }) => name);
  const format = ROW_FORMATS.find((one) => hasPaths(one, paths)) ?? 'doubleList';
  const others = columns.filter(({ type }) => type !== 'number');
  return [{ topic: base, format, columns: numbers }, ...others.map((one) => ofColumn(one, base))];
}

function ofColumn(column: CsvColumn, base: string): CsvTopic {
  const format = column.type === 'number' ? 'double' : column.type;
  const level = levelOf(column.name) || `column-${column.place + 1}`;
  return { topic: `${base}/${level}`, format, columns: [column] };
}

/** A name as a level of a topic. */
export function levelOf(name: string): string {
  return name.replaceAll(/[^\p{L}\p{N}_.-]+/gu, '-').replaceAll(/^-+|-+$/g, '');
}
