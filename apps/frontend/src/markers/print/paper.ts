/** Sizes of paper, millimetres. */
export const PAPERS = {
  A4: { width: 210, height: 297, page: 'A4' },
  Letter: { width: 215.9, height: 279.4, page: 'letter' },
} as const;

export type PaperName = keyof typeof PAPERS;

/** Margin, millimetres: printers leave up to 6 mm blank at the edges. */
export const MARGIN = 10;
/** Height of the control ruler with its text at the bottom, millimetres. */
export const FOOTER = 16;

/** Returns the area for markers, millimetres. */
export function usableArea(paper: PaperName) {
  const { width, height } = PAPERS[paper];
  return { width: width - 2 * MARGIN, height: height - 2 * MARGIN - FOOTER };
}

/** A page to print; all in millimetres from the top left. */
export interface Sheet {
  readonly paper: PaperName;
  /** Black areas as an SVG path. */
  readonly ink: string;
  readonly labels: readonly { readonly x: number; readonly y: number; readonly text: string }[];
  /** Cutting lines as an SVG path. */
  readonly cuts: string;
}

/** SVG path of black cells: one rectangle for adjacent cells of a row. */
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

/** Rounds to a tenth of a micrometre, finer than any printer. */
const mm = (value: number): number => Math.round(value * 10_000) / 10_000;
