/** Sizes of paper, millimetres. */
export const PAPERS = {
  A4: { width: 210, height: 297, page: 'A4' },
  Letter: { width: 215.9, height: 279.4, page: 'letter' },
} as const;

export type PaperName = keyof typeof PAPERS;

/** Printers leave up to 6 mm at the edges white. */
export const MARGIN = 10;
/** Of the control ruler below, with its words. */
export const FOOTER = 16;

/** Where markers can be, millimetres. */
export function usableArea(paper: PaperName) {
  const { width, height } = PAPERS[paper];
  return { width: width - 2 * MARGIN, height: height - 2 * MARGIN - FOOTER };
}

/** One page to print; all in millimetres from the top left. */
export interface Sheet {
  readonly paper: PaperName;
  /** What is black, as the path of an SVG. */
  readonly ink: string;
  readonly labels: readonly { readonly x: number; readonly y: number; readonly text: string }[];
  /** Where to cut, as the path of an SVG. */
  readonly cuts: string;
}

/** Black cells as the path of an SVG: one rectangle for cells that touch in a row. */
export function inkOfCells(
  cells: readonly (readonly boolean[])[],
  left: number,
  top: number,
  cell: number,
): string {
  let path = '';
  for (const [row, line] of cells.entries()) {
    for (let from = 0; from < line.length; from++) {
      if (!line[from]) continue;
      let to = from + 1;
      while (line[to]) to++;
      path += rectangle(left + from * cell, top + row * cell, (to - from) * cell, cell);
      from = to;
    }
  }
  return path;
}

export function rectangle(x: number, y: number, width: number, height: number): string {
  return `M${mm(x)} ${mm(y)}h${mm(width)}v${mm(height)}h${mm(-width)}z`;
}

/** A tenth of a micrometre is finer than any printer. */
const mm = (value: number): number => Math.round(value * 10_000) / 10_000;
