import type { TablePiece } from './game.ts';

type Standing = Omit<TablePiece, 'seat'>;

/**
 * Position of a piece on a big screen on which all stand in rows of a block that parts to both sides: no piece hides
 * another.
 *
 * @param x from -1 for one side to 1 for the other
 * @param index of the piece, of all that there are
 */
export function standInRows(x: number, index: number, of: number): Standing {
  const perRow = of <= 4 ? 2 : of <= 12 ? 4 : 6;
  const rows = Math.ceil(of / perRow);
  const [row, column] = [Math.floor(index / perRow), index % perRow];
  const aside = (column + (row % 2 === 0 ? 0.25 : -0.25) - (perRow - 1) / 2) * (7.2 / perRow);
  const deep = Math.min(4.6, 11 / Math.max(1, rows - 1));
  return { x: x * 0.83 + aside, y: -8.5 + row * deep, isOut: false };
}
