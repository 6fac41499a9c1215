import { binStartMs } from '../measure/histogram.ts';
import { readResult, ResultFormatError } from './read-result.ts';
import type { TestResult } from './test-result.ts';

const FORMAT = 'ubi-interact-performance';
const FORMAT_VERSION = 1;
/** Results of one file: as many as are kept. */
export const MAX_RESULTS_OF_FILE = 100;

/** Results as a JSON file: everything, to be imported again. */
export function resultsToJson(results: readonly TestResult[]): string {
  return `${JSON.stringify({ format: FORMAT, formatVersion: FORMAT_VERSION, results }, undefined, 2)}\n`;
}

/**
 * Reads what `resultsToJson` wrote.
 * @throws ResultFormatError with a sentence for people
 */
export function resultsFromJson(text: string): TestResult[] {
  let file: unknown;
  try {
    file = JSON.parse(text);
  } catch {
    throw new ResultFormatError('The file', 'JSON, as exported by this page');
  }
  const { format, formatVersion, results } = (file ?? {}) as Record<string, unknown>;
  if (format !== FORMAT) {
    throw new ResultFormatError('The file', 'a JSON export of this page');
  }
  if (formatVersion !== FORMAT_VERSION) {
    throw new ResultFormatError('The version of the file', `${FORMAT_VERSION}`);
  }
  if (!Array.isArray(results) || results.length === 0 || results.length > MAX_RESULTS_OF_FILE) {
    throw new ResultFormatError('results', `a list of 1 to ${MAX_RESULTS_OF_FILE} results`);
  }
  return results.map((one, index) => readResult(one, `results[${index}]`));
}

const HEAD = ['result', 'test', 'started', 'section', 'key', 'label', 'x', 'value', 'unit'];

/** Results as a table in the long form: one value a line, for spreadsheets and statistics programs. */
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

/** RFC 4180; what a spreadsheet would take for a formula is kept from it. */
function csvField(value: Cell): string {
  if (typeof value === 'number') return String(value);
  const safe = /^[=+\-@\t\r]/.test(value) ? `'${value}` : value;
  return /[",\r\n]/.test(safe) ? `"${safe.replaceAll('"', '""')}"` : safe;
}
