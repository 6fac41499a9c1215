import { markerDictionary } from './dictionaries.ts';

/** A chessboard with markers in its white squares, by which cameras are calibrated. */
export interface CharucoBoard {
  /** Squares in a row. */
  readonly columns: number;
  readonly rows: number;
  /** Side of a square, metres. */
  readonly squareMetres: number;
  /** Side of a marker, metres; smaller than a square. */
  readonly markerMetres: number;
  readonly dictionary: string;
}

/** Fits A4 and Letter. Its markers are of another dictionary than those that are tracked by default. */
export const DEFAULT_BOARD: CharucoBoard = {
  columns: 5,
  rows: 7,
  squareMetres: 0.032,
  markerMetres: 0.024,
  dictionary: 'aruco_5x5_50',
};

/** Fewer corners do not tell a lens; more squares are too small to be seen. */
const SQUARES = { min: 3, max: 16 };

/**
 * Checks a board.
 *
 * @throws RangeError that says what is wrong
 */
export function checkBoard(board: CharucoBoard): void {
  const { columns, rows, squareMetres, markerMetres, dictionary } = board;
  const isCount = (count: number): boolean =>
    Number.isInteger(count) && count >= SQUARES.min && count <= SQUARES.max;
  if (!isCount(columns) || !isCount(rows)) {
    throw new RangeError(
      `A board has ${SQUARES.min} to ${SQUARES.max} squares in a row and a column.`,
    );
  }
  if (!(markerMetres > 0 && markerMetres < squareMetres && squareMetres <= 10)) {
    throw new RangeError('The markers of a board are smaller than its squares.');
  }
  const { count } = markerDictionary(dictionary);
  const needed = Math.floor((columns * rows) / 2);
  if (needed > count) {
    throw new RangeError(`This board needs ${needed} markers, and ${dictionary} has ${count}.`);
  }
}

/** The squares with markers, in the order of their ids: rows from the top; the first square is black. */
export function boardMarkers({ columns, rows }: CharucoBoard): readonly {
  readonly id: number;
  readonly column: number;
  readonly row: number;
}[] {
  return boardSquares(columns, rows, (column, row) => (column + row) % 2 === 1).map(
    (square, id) => ({ id, ...square }),
  );
}

/** The black squares. */
export function blackSquares({
  columns,
  rows,
}: CharucoBoard): readonly { readonly column: number; readonly row: number }[] {
  return boardSquares(columns, rows, (column, row) => (column + row) % 2 === 0);
}

function boardSquares(
  columns: number,
  rows: number,
  isWanted: (column: number, row: number) => boolean,
) {
  return Array.from({ length: columns * rows }, (_, index) => ({
    column: index % columns,
    row: Math.floor(index / columns),
  })).filter(({ column, row }) => isWanted(column, row));
}
