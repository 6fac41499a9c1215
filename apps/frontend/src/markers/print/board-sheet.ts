import {
  blackSquares,
  boardMarkers,
  type CharucoBoard,
  checkBoard,
  markerCells,
  markerDictionary,
} from '@ubii/vision/markers';
import { inkOfCells, MARGIN, type PaperName, rectangle, type Sheet, usableArea } from './paper.ts';

/** Height of the text line below the board, millimetres. */
const LABEL = 6;

/** Returns why a board cannot be printed, one sentence. */
export function boardProblem(board: CharucoBoard, paper: PaperName): string | undefined {
  try {
    checkBoard(board);
  } catch (error) {
    return (error as RangeError).message;
  }
  const { width, height } = usableArea(paper);
  const most = Math.min(width / board.columns, (height - LABEL) / board.rows);
  if (board.squareMetres * 1000 > most + 1e-6) {
    return `On ${paper} the maximum size of a square of this board is ${Math.floor(most)} mm.`;
  }
  return undefined;
}

/** Returns a sheet with a centred board. */
export function boardSheet(board: CharucoBoard, paper: PaperName): Sheet {
  const { columns, rows, dictionary: name } = board;
  const dictionary = markerDictionary(name);
  const square = board.squareMetres * 1000;
  const marker = board.markerMetres * 1000;
  const inset = (square - marker) / 2;
  const area = usableArea(paper);
  const left = MARGIN + (area.width - columns * square) / 2;
  const at = (column: number, row: number) => ({
    x: left + column * square,
    y: MARGIN + row * square,
  });
  const squares = blackSquares(board).map(({ column, row }) => {
    const { x, y } = at(column, row);
    return rectangle(x, y, square, square);
  });
  const markers = boardMarkers(board).map(({ id, column, row }) => {
    const { x, y } = at(column, row);
    const cell = marker / (dictionary.cells + 2);
    return inkOfCells(markerCells(dictionary, id), x + inset, y + inset, cell);
  });
  return {
    paper,
    ink: [...squares, ...markers].join(''),
    labels: [
      {
        x: left + (columns * square) / 2,
        y: MARGIN + rows * square + LABEL - 1,
        text: `Calibration board ${columns} × ${rows} · squares ${square} mm · markers ${marker} mm · ${name}`,
      },
    ],
    cuts: '',
  };
}
