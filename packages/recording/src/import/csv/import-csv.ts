import { isDataFormat, type DataFormat } from '@ubii/proto';
import { CSV_HEAD } from '../../export/csv.ts';
import { RecordingError } from '../../records/recording-error.ts';
import type { RecordingSink, RecordingSource } from '../../storage/recording-storage.ts';
import { BufferedSource } from '../buffered-source.ts';
import {
  ImportWriter,
  type ImportedValue,
  type ImportOptions,
  type ImportResult,
} from '../import-writer.ts';
import { valueFromPaths } from '../value-from-paths.ts';
import {
  isMissing,
  numberIn,
  planCsv,
  isRelative,
  parseTimeNs,
  type CsvColumn,
  type CsvOptions,
  type CsvPlan,
  type CsvTopic,
} from './csv-plan.ts';
import { csvRows, type CsvRow } from './csv-rows.ts';

/** Says how a table would be imported. @throws RecordingError when it is none */
export async function previewCsv(
  source: RecordingSource,
  options: Pick<ImportOptions, 'name'> & CsvOptions,
): Promise<CsvPlan> {
  return planCsv(await BufferedSource.open(source), options.name, options);
}

/**
 * Imports a table with a header row as a recording. An export of a recording becomes what it was, except for bytes such as
 * pixels; of other tables, one column has the times, and each other column or each row becomes a topic.
 *
 * @throws RecordingError that names line and column; the reason of the signal; the error of the sink
 */
export async function importCsv(
  source: RecordingSource,
  sink: RecordingSink,
  options: ImportOptions & CsvOptions,
): Promise<ImportResult> {
  const file = await BufferedSource.open(source);
  const plan = await planCsv(file, options.name, options);
  if (plan.time === undefined) {
    const names = plan.names.map((name) => `"${name}"`).join(', ');
    throw new RecordingError(`No column has times. Choose one of ${names}.`);
  }
  const writer = await ImportWriter.create(sink, options, notesOf(plan));
  const isWanted = (topic: string): boolean => options.topics?.includes(topic) !== false;
  const valuesOf = plan.isExport ? exportedValues(plan) : tableValues(plan, options);
  let pictures = 0;
  let isHeader = true;
  for await (const row of csvRows(file, plan.delimiter)) {
    if (row.cells.length !== plan.names.length) {
      throw new RecordingError(
        `Line ${row.line} has ${row.cells.length} cells, and the header has ${plan.names.length}.`,
      );
    }
    if (!isHeader) {
      for (const value of valuesOf(row)) {
        if (!isWanted(value.topic)) continue;
        if (value.format === 'image2D' || value.format === 'image2DList') pictures++;
        else {
          writer.addClient(value.clientId, value.clientId, value.logTimeNs);
          await writer.addValue(value, row.readBytes / file.size);
        }
      }
    }
    isHeader = false;
  }
  const leftOut =
    pictures > 0 ? [`${pictures} pictures were left out: tables have no pixels.`] : [];
  return writer.end(leftOut);
}

/** Names that are not in the recording otherwise. */
function notesOf({ topics }: CsvPlan): string {
  return topics
    .filter(({ columns }) => columns.length > 1)
    .map(({ topic, columns }) => `${topic}: ${columns.map(({ name }) => name).join(', ')}`)
    .join('\n');
}

type ValuesOf = (row: CsvRow) => Iterable<ImportedValue>;

function failAt({ line }: CsvRow, column: string, sentence: string): never {
  throw new RecordingError(`Line ${line}, column "${column}": ${sentence}`);
}

/** Rows of an export. */
function exportedValues({ names }: CsvPlan): ValuesOf {
  const at = (name: (typeof CSV_HEAD)[number]): number => CSV_HEAD.indexOf(name);
  const timeAt = (row: CsvRow, name: 'time' | 'arrived'): bigint => {
    const text = row.cells[at(name)]!;
    return parseTimeNs(text, 'iso') ?? failAt(row, name, `"${text}" is no time.`);
  };
  const members = names.slice(CSV_HEAD.length);
  return (row) => {
    const format = row.cells[at('format')]!;
    if (format !== '' && !isDataFormat(format))
      failAt(row, 'format', `"${format}" is no data format.`);
    const topic = row.cells[at('topic')]!;
    if (topic === '') failAt(row, 'topic', 'it is empty.');
    const cells = row.cells.slice(CSV_HEAD.length);
    const leaves = members.flatMap((name, place): [string, string][] => {
      const cell = cells[place]!;
      return cell === '' ? [] : [[name, withoutEscape(cell)]];
    });
    return [
      {
        topic: topic.startsWith('/') ? topic : `/${topic}`,
        clientId: withoutEscape(row.cells[at('publisher')]!),
        format: format === '' ? undefined : (format as DataFormat),
        value: format === '' ? undefined : fitting(row, format as DataFormat, leaves),
        publishTimeNs: timeAt(row, 'time'),
        logTimeNs: timeAt(row, 'arrived'),
      },
    ];
  };
}

/** Texts that begin as formulas do were exported with `'` before them. */
const withoutEscape = (cell: string): string => cell.replace(/^'(?=[=+@\t\r-])/, '');

function fitting(row: CsvRow, format: DataFormat, leaves: readonly [string, unknown][]): unknown {
  try {
    return valueFromPaths(format, leaves);
  } catch (error) {
    if (!(error instanceof RecordingError)) throw error;
    throw new RecordingError(`Line ${row.line}: ${error.message}`);
  }
}

/** Rows of any table. */
function tableValues(plan: CsvPlan, { startMs = 0 }: ImportOptions): ValuesOf {
  const { place, unit } = plan.time!;
  const startNs = BigInt(Math.round(startMs)) * 1_000_000n;
  return function* (row) {
    const text = row.cells[place]!;
    const read = parseTimeNs(text, unit);
    if (read === undefined) failAt(row, plan.names[place]!, `"${text}" is no time.`);
    const timeNs = isRelative(read) ? startNs + read : read;
    for (const topic of plan.topics) {
      const value = valueOf(row, topic, plan);
      if (value === undefined) continue;
      const { format } = topic;
      const times = { publishTimeNs: timeNs, logTimeNs: timeNs };
      yield { topic: topic.topic, clientId: '', format, value, ...times };
    }
  };
}

/** Undefined where the row has no value. */
function valueOf(row: CsvRow, { format, columns }: CsvTopic, plan: CsvPlan): unknown {
  const cells = columns.map((column) => cellOf(row, column, plan));
  if (cells.every((cell) => cell === undefined)) return undefined;
  if (columns.length === 1 && format !== 'doubleList') return cells[0];
  const numbers = cells.map((cell) => cell ?? NaN);
  if (format === 'doubleList') return { elements: numbers };
  return fitting(
    row,
    format,
    columns.map(({ name }, at) => [name, numbers[at]]),
  );
}

function cellOf(row: CsvRow, { name, place, type }: CsvColumn, { delimiter }: CsvPlan) {
  const cell = row.cells[place]!;
  if (type === 'string') return cell === '' ? undefined : withoutEscape(cell);
  if (isMissing(cell)) return undefined;
  if (type === 'number') {
    return (
      numberIn(cell, delimiter) ??
      failAt(row, name, `"${cell}" is not a number, as the values before are.`)
    );
  }
  const isTrue = /^true$/i.test(cell.trim());
  if (!isTrue && !/^false$/i.test(cell.trim()))
    failAt(row, name, `"${cell}" is neither true nor false, as the values before are.`);
  return isTrue;
}
