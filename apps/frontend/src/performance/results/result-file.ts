import * as v from 'valibot';
import { readImported, type ImportKind, type Imported } from '../../json/read-imported.ts';
import { binStartMs } from '../measure/histogram.ts';
import { RESULT } from './result-schema.ts';
import type { TestResult } from './test-result.ts';

const FORMAT = 'ubi-interact-performance';
const FORMAT_VERSION = 1;
/** Most results per file, the same as stored. */
export const MAX_RESULTS_OF_FILE = 100;

const RESULTS: ImportKind = {
  what: 'performance results',
  mark: ['format', FORMAT],
  version: ['formatVersion', FORMAT_VERSION],
  maxChars: 50_000_000,
};
const RESULTS_FILE = v.pipe(
  v.object({
    results: v.pipe(v.array(RESULT), v.minLength(1), v.maxLength(MAX_RESULTS_OF_FILE)),
  }),
  v.transform(({ results }) => results),
);

/** Exports complete results as JSON, for import. */
export function resultsToJson(results: readonly TestResult[]): string {
  return `${JSON.stringify({ format: FORMAT, formatVersion: FORMAT_VERSION, results }, undefined, 2)}\n`;
}

/** Parses the output of `resultsToJson`. */
export function resultsFromJson(text: string): Imported<readonly TestResult[]> {
  return readImported(RESULTS, RESULTS_FILE, text);
}

const HEAD = ['result', 'test', 'started', 'section', 'key', 'label', 'x', 'value', 'unit'];

/** Exports results as CSV in long form: one value per line, for spreadsheets and statistics programs. */
export function resultsToCsv(results: readonly TestResult[]): string {
  const lines = [HEAD, ...results.flatMap(linesOf)];
  return `${lines.map((line) => line.map(csvField).join(',')).join('\r\n')}\r\n`;
}

type Cell = string | number;

function linesOf(result: TestResult): Cell[][] {
  const { name, kind, startedMs, parameters, circumstances, findings } = result;
  const first: Cell[] = [name, kind, new Date(startedMs).toISOString()];
  const line = (section: string, ...cells: Cell[]): Cell[] => [...first, section, ...cells];
  return [
    ...parameters.map((one) =>
      line('parameter', one.key, one.label, '', one.value, one.unit ?? ''),
    ),
    ...circumstances.map((one) => line('circumstance', one.key, one.label, '', one.value, '')),
    ...findings.figures.map((one) => line('figure', one.key, one.label, '', one.value, one.unit)),
    ...findings.histograms.flatMap(({ key, title, firstBin, counts }) =>
      counts.map((count, index) =>
        line('histogram', key, title, rounded(binStartMs(firstBin + index)), count, 'count'),
      ),
    ),
    ...findings.curves.flatMap(({ key, x, y, lines }) =>
      lines.flatMap(({ key: lineKey, label, values }) =>
        values.flatMap((value, index) =>
          value === null
            ? []
            : [line('curve', `${key}.${lineKey}`, label, x.values[index] ?? '', value, y.unit)],
        ),
      ),
    ),
    ...findings.notes.map((note) => line('note', '', '', '', note, '')),
  ];
}

const rounded = (value: number): number => Number(value.toPrecision(4));

/** Escapes a field (RFC 4180) and prevents spreadsheets from evaluating it as a formula. */
function csvField(value: Cell): string {
  if (typeof value === 'number') return String(value);
  const safe = /^[=+\-@\t\r]/.test(value) ? `'${value}` : value;
  return /[",\r\n]/.test(safe) ? `"${safe.replaceAll('"', '""')}"` : safe;
}
