import type { DataFormat } from '@ubii/proto';

import { CSV_HEAD } from '../../export/csv.ts';
import { RecordingError } from '../../records/recording-error.ts';
import type { BufferedSource } from '../buffered-source.ts';
import { hasPaths } from '../value-from-paths.ts';
import { csvRows, delimiterOf, type CsvRow, type Delimiter } from './csv-rows.ts';

/** How a column states times. */
export type TimeUnit = 's' | 'ms' | 'us' | 'ns' | 'iso';

/** Decimals of a nanosecond. */
const DECIMALS: Readonly<Record<Exclude<TimeUnit, 'iso'>, number>> = { s: 9, ms: 6, us: 3, ns: 0 };

const ISO =
  /^(\d{4}-\d\d-\d\d)(?:[T ](\d\d:\d\d)(?::(\d\d)(?:[.,](\d+))?)?)?\s*(Z|[+-]\d\d:?\d\d)?$/;

/** Nanoseconds of a time; without a zone it is UTC. Undefined when it is none. */
export function parseTimeNs(text: string, unit: TimeUnit): bigint | undefined {
  const trimmed = text.trim();
  return unit === 'iso' ? parseIso(trimmed) : parseDecimal(trimmed, DECIMALS[unit]);
}

function parseIso(text: string): bigint | undefined {
  const [, date, minutes = '00:00', seconds = '00', decimals = '', zone = 'Z'] =
    ISO.exec(text) ?? [];
  if (date === undefined) return undefined;
  const zoned = zone === 'Z' ? zone : zone.replace(/^(...):?/, '$1:');
  const ms = Date.parse(`${date}T${minutes}:${seconds}${zoned}`);
  if (Number.isNaN(ms)) return undefined;
  return BigInt(ms) * 1_000_000n + BigInt(decimals.padEnd(9, '0').slice(0, 9));
}

/** A decimal number without the loss of a double. */
function parseDecimal(text: string, scale: number): bigint | undefined {
  const match = /^([+-]?)(\d*)(?:[.,](\d*))?(?:[eE]([+-]?\d{1,3}))?$/.exec(text);
  if (match === null) return undefined;
  const [, sign, whole = '', part = '', exponent = '0'] = match;
  if (whole === '' && part === '') return undefined;
  const places = whole.length + scale + Number(exponent);
  const digits = `${whole}${part}`;
  const shown = places <= 0 ? '0' : digits.padEnd(places, '0').slice(0, places);
  const ns = BigInt(shown);
  return sign === '-' ? -ns : ns;
}

const NAME = /^(time|timestamp|t|date|datetime|utc|epoch|unix|zeit)([ _.\-(\][]|stamp|$)/i;
const UNIT_OF_NAME = /(?:^|[ _.\-([])(ns|us|µs|ms|s|sec|seconds?|millis|milliseconds?)[)\]]?$/i;

/** Whether a column is named as times are. */
const isTimeName = (name: string): boolean => NAME.test(name.trim());

/** The unit of a column, by its name, else by its values. Undefined when they are no times. */
function unitOf(name: string, values: readonly string[]): TimeUnit | undefined {
  const known = values.filter((value) => value.trim() !== '');
  if (known.length === 0) return undefined;
  if (known.every((value) => parseTimeNs(value, 'iso') !== undefined)) return 'iso';
  if (!known.every((value) => parseTimeNs(value, 's') !== undefined)) return undefined;
  const [, unit] = UNIT_OF_NAME.exec(name.trim()) ?? [];
  if (unit !== undefined) return unitOfWord(unit.toLowerCase());
  const first = Math.abs(Number(known[0]!.replace(',', '.')));
  // Numbers of this size are times since 1970, of the years from 2001 on.
  if (first >= 1e18) return 'ns';
  if (first >= 1e15) return 'us';
  return first >= 1e12 ? 'ms' : 's';
}

function unitOfWord(word: string): TimeUnit {
  if (word === 'ns') return 'ns';
  if (word === 'us' || word === 'µs') return 'us';
  return word.startsWith('ms') || word.startsWith('milli') ? 'ms' : 's';
}

/** Times before 1973 count from the beginning of the recording and not from 1970. */
export const isRelative = (timeNs: bigint): boolean => timeNs < 100_000_000_000_000_000n;

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

/** Formats of rows that follow from the names of their columns. */
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
