import { blackSquares, boardMarkers, type CharucoBoard } from '../src/markers/charuco-board.ts';
import { markerDictionary, markerCells } from '../src/markers/dictionaries.ts';

/** Brightness of a board by place, metres from its centre, x right, y up; undefined beside it. */
export function boardBrightness(board: CharucoBoard): (x: number, y: number) => number | undefined {
  const { columns, rows, squareMetres: square, markerMetres, dictionary } = board;
  const family = markerDictionary(dictionary);
  const black = new Set(blackSquares(board).map(({ column, row }) => row * columns + column));
  const markers = new Map(
    boardMarkers(board).map(({ id, column, row }) => [
      row * columns + column,
      markerCells(family, id),
    ]),
  );
  const cell = markerMetres / (family.cells + 2);
  const inset = (square - markerMetres) / 2;
  return (x, y) => {
    const across = x + (columns * square) / 2;
    const down = (rows * square) / 2 - y;
    const margin = square / 2;
    if (across < -margin || across > columns * square + margin) return undefined;
    if (down < -margin || down > rows * square + margin) return undefined;
    const [column, row] = [Math.floor(across / square), Math.floor(down / square)];
    if (column < 0 || column >= columns || row < 0 || row >= rows) return 1;
    const key = row * columns + column;
    if (black.has(key)) return 0;
    const cells = markers.get(key)!;
    const cellColumn = Math.floor((across - column * square - inset) / cell);
    const cellRow = Math.floor((down - row * square - inset) / cell);
    return cells[cellRow]?.[cellColumn] === true ? 0 : 1;
  };
}
