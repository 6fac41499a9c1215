import { DEFAULT_BOARD, DEFAULT_DICTIONARY, markerDictionary } from '@ubii/vision/markers';
import { computed, reactive } from 'vue';
import { boardProblem, boardSheet } from './board-sheet.ts';
import { markerPrintProblem, markerSheets } from './marker-sheets.ts';
import type { PaperName } from './paper.ts';

export type PrintKind = 'markers' | 'board';

/** Side length of a marker relative to its square. */
const MARKER_PART = DEFAULT_BOARD.markerMetres / DEFAULT_BOARD.squareMetres;

/** State of printing: fields, and the resulting sheets. */
export function usePrint(kind: PrintKind) {
  const fields = reactive({
    kind,
    paper: 'A4' as PaperName,
    dictionary: DEFAULT_DICTIONARY,
    from: '0',
    to: '5',
    sizeMm: '60',
    borderMm: '12',
    hasLabels: true,
    hasCuts: true,
    columns: String(DEFAULT_BOARD.columns),
    rows: String(DEFAULT_BOARD.rows),
    squareMm: String(DEFAULT_BOARD.squareMetres * 1000),
  });
  const print = computed(() => ({
    paper: fields.paper,
    dictionary: markerDictionary(fields.dictionary),
    from: number(fields.from),
    to: number(fields.to),
    sizeMm: number(fields.sizeMm),
    borderMm: number(fields.borderMm),
    hasLabels: fields.hasLabels,
    hasCuts: fields.hasCuts,
  }));
  const board = computed(() => {
    const squareMetres = number(fields.squareMm) / 1000;
    return {
      columns: number(fields.columns),
      rows: number(fields.rows),
      squareMetres,
      markerMetres: squareMetres * MARKER_PART,
      dictionary: DEFAULT_BOARD.dictionary,
    };
  });
  const problem = computed(() =>
    fields.kind === 'markers'
      ? markerPrintProblem(print.value)
      : boardProblem(board.value, fields.paper),
  );
  const sheets = computed(() => {
    if (problem.value !== undefined) return [];
    return fields.kind === 'markers'
      ? markerSheets(print.value)
      : [boardSheet(board.value, fields.paper)];
  });
  return { fields, print, board, problem, sheets };
}

const number = (text: string): number => (text.trim() === '' ? NaN : Number(text));
