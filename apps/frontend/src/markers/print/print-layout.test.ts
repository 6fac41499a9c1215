import { DEFAULT_BOARD, markerDictionary } from '@ubii/vision/markers';
import { describe, expect, it } from 'vitest';
import { boardProblem, boardSheet } from './board-sheet.ts';
import { type MarkerPrint, markerPrintProblem, markerSheets } from './marker-sheets.ts';
import { FOOTER, inkOfCells, MARGIN, PAPERS } from './paper.ts';

const PRINT: MarkerPrint = {
  paper: 'A4',
  dictionary: markerDictionary('aruco_4x4_50'),
  from: 0,
  to: 9,
  sizeMm: 60,
  borderMm: 12,
  hasLabels: true,
  hasCuts: true,
};

/** Returns the rectangles of a path, millimetres. */
function rectangles(path: string) {
  return [...path.matchAll(/M([\d.]+) ([\d.]+)h([\d.]+)v([\d.]+)/g)].map(([, ...parts]) => {
    const [x, y, width, height] = parts.map(Number) as [number, number, number, number];
    return { x, y, width, height, right: x + width, bottom: y + height };
  });
}

describe('sheets of markers', () => {
  it('have markers of the size asked for, within the paper and above the ruler', () => {
    const sheets = markerSheets(PRINT);
    // 2 × 2 tiles of 84 × 89 mm on 190 × 261 mm.
    expect(sheets.map(({ labels }) => labels.length)).toEqual([4, 4, 2]);
    const first = rectangles(sheets[0]!.ink).filter(
      ({ right, bottom }) => right < 105 && bottom < 99,
    );
    const left = Math.min(...first.map(({ x }) => x));
    const top = Math.min(...first.map(({ y }) => y));
    expect(Math.max(...first.map(({ right }) => right)) - left).toBeCloseTo(60);
    expect(Math.max(...first.map(({ bottom }) => bottom)) - top).toBeCloseTo(60);
    for (const { right, bottom } of rectangles(sheets[0]!.ink)) {
      expect(right).toBeLessThanOrEqual(PAPERS.A4.width - MARGIN);
      expect(bottom).toBeLessThanOrEqual(PAPERS.A4.height - MARGIN - FOOTER);
    }
    expect(sheets[2]!.labels.map(({ text }) => text)).toEqual([
      'aruco_4x4_50:8 · 60 mm',
      'aruco_4x4_50:9 · 60 mm',
    ]);
  });

  it('keep labels and lines to cut away when they are not wanted', () => {
    const [sheet] = markerSheets({ ...PRINT, hasLabels: false, hasCuts: false });
    expect(sheet).toMatchObject({ labels: [], cuts: '' });
  });

  it.each([
    ['ids beyond the dictionary', { to: 50 }, '0 to 49'],
    ['ids that are not numbers', { from: NaN }, '0 to 49'],
    ['ids in the wrong order', { from: 5, to: 2 }, 'lower one first'],
    ['a border that is too narrow', { borderMm: 9 }, '10.0 mm'],
    ['a marker that is too large', { sizeMm: 180, borderMm: 30 }, 'maximum size'],
    ['a marker without a size', { sizeMm: NaN }, 'is 5 mm'],
  ])('are refused for %s', (_what, change, message) => {
    expect(markerPrintProblem({ ...PRINT, ...change })).toContain(message);
  });

  it('merge cells that touch in a row', () => {
    expect(inkOfCells([[true, true, false, true]], 0, 0, 2)).toBe('M0 0h4v2h-4zM6 0h2v2h-2z');
  });

  it.each(['A4', 'Letter'] as const)('fit what the page begins with on %s', (paper) => {
    expect(markerPrintProblem({ ...PRINT, paper, to: 5 })).toBeUndefined();
    expect(boardProblem(DEFAULT_BOARD, paper)).toBeUndefined();
  });
});

describe('the sheet of a board', () => {
  it('has the board in true size, the first square black', () => {
    const squares = rectangles(boardSheet(DEFAULT_BOARD, 'A4').ink);
    const [left, top] = [Math.min(...squares.map(({ x }) => x)), MARGIN];
    expect(squares[0]).toMatchObject({ x: left, y: top, width: 32, height: 32 });
    expect(Math.max(...squares.map(({ right }) => right)) - left).toBeCloseTo(5 * 32);
    expect(Math.max(...squares.map(({ bottom }) => bottom)) - top).toBeCloseTo(7 * 32);
  });

  it('is refused when it does not fit, or has too few squares', () => {
    expect(boardProblem({ ...DEFAULT_BOARD, squareMetres: 0.05 }, 'A4')).toContain('36 mm');
    expect(boardProblem({ ...DEFAULT_BOARD, columns: 2 }, 'A4')).toContain('3 to 16');
  });
});
