import type { CvCharucoDetector, CvMat, OpenCv } from '../opencv/open-cv.ts';
import type { Keep, OpenCvRuntime } from '../opencv/open-cv-runtime.ts';
import { type CharucoBoard, checkBoard } from './charuco-board.ts';
import { markerDictionary } from './dictionaries.ts';
import type { PixelPoint } from './marker-pose.ts';

/** A corner between four squares of a board; numbered from 0, rows from the top. */
export interface BoardCorner extends PixelPoint {
  readonly id: number;
}

/** Finds the corners of a board. Holds memory of OpenCV until it is disposed. */
export class BoardDetector {
  readonly #runtime: OpenCvRuntime;
  readonly #board: CharucoBoard;
  #detector: { cv: OpenCv; native: CvCharucoDetector } | undefined;

  /** @throws RangeError for a board that cannot be */
  constructor(runtime: OpenCvRuntime, board: CharucoBoard) {
    checkBoard(board);
    this.#runtime = runtime;
    this.#board = board;
  }

  /** The corners of the board in a picture; none when it is not there. */
  detect(cv: OpenCv, keep: Keep, image: CvMat): BoardCorner[] {
    const corners = keep(new cv.Mat());
    const ids = keep(new cv.Mat());
    // Empty ones: markers that are handed in are taken for those of the picture
    const markerCorners = keep(new cv.MatVector());
    const markerIds = keep(new cv.Mat());
    this.#nativeDetector(cv, keep).detectBoard(image, corners, ids, markerCorners, markerIds);
    const numbers = Array.from(ids.data32S.subarray(0, ids.rows * ids.cols));
    const places = corners.data32F;
    return numbers.map((id, index) => ({
      id,
      x: places[2 * index]!,
      y: places[2 * index + 1]!,
    }));
  }

  /** Returns the position of a corner on the board, metres from its top left; x right, y up. */
  placeOf(id: number): readonly [x: number, y: number, z: number] {
    const { columns, squareMetres } = this.#board;
    const column = id % (columns - 1);
    const row = Math.floor(id / (columns - 1));
    return [(column + 1) * squareMetres, -(row + 1) * squareMetres, 0];
  }

  dispose(): void {
    // Of an OpenCV that stopped, nothing can be deleted
    if (this.#detector && this.#runtime.owns(this.#detector.cv)) this.#detector.native.delete();
    this.#detector = undefined;
  }

  #nativeDetector(cv: OpenCv, keep: Keep): CvCharucoDetector {
    if (this.#detector?.cv === cv) return this.#detector.native;
    this.#detector = undefined;
    const { columns, rows, squareMetres, markerMetres, dictionary } = this.#board;
    const board = keep(
      new cv.aruco_CharucoBoard(
        new cv.Size(columns, rows),
        squareMetres,
        markerMetres,
        keep(cv.getPredefinedDictionary(markerDictionary(dictionary).opencv)),
        keep(new cv.Mat()),
      ),
    );
    const native = new cv.aruco_CharucoDetector(
      board,
      keep(new cv.aruco_CharucoParameters()),
      keep(new cv.aruco_DetectorParameters()),
      keep(new cv.aruco_RefineParameters(10, 3, true)),
    );
    this.#detector = { cv, native };
    return native;
  }
}
