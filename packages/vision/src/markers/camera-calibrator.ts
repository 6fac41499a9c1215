import type { CvMat, OpenCv } from '../opencv/open-cv.ts';
import type { Keep, OpenCvRuntime } from '../opencv/open-cv-runtime.ts';
import type { Picture } from '../picture.ts';
import { type BoardCorner, BoardDetector } from './board-detector.ts';
import {
  type CalibrationView,
  isNewView,
  isStill,
  MIN_CORNERS,
  nextHint,
  WANTED_VIEWS,
} from './calibration-views.ts';
import { assumedCalibration, type CameraCalibration } from './camera-calibration.ts';
import type { CharucoBoard } from './charuco-board.ts';
import { greyForDetection } from './grey-for-detection.ts';
import { cameraMats, orientationOf, type PixelPoint } from './marker-pose.ts';
import { quaternionOfAxisAngle, rotate, type Vector3Value } from './rotations.ts';

/** Result of one picture. */
export interface CalibrationLook {
  /** Corners of the board, 0 to 1 of width and height. */
  readonly corners: readonly (PixelPoint & { readonly id: number })[];
  /** Whether the picture counts as a view. */
  readonly isTaken: boolean;
  /** Views so far; `WANTED_VIEWS` are enough. */
  readonly views: number;
  /** Next step for the user, one sentence. */
  readonly hint: string;
  /** When there are enough views. */
  readonly calibration?: CameraCalibration;
}

/** CALIB_FIX_K3: with a board that does not reach the corners of the picture, k3 is guesswork. */
const FIX_K3 = 128;
/** solvePnP's SOLVEPNP_ITERATIVE. */
const ITERATIVE = 0;
/** Focal lengths of cameras, in widths of the picture: 150 to 5 degrees. */
const FOCAL = { min: 0.13, max: 11.5 };

/**
 * A calibrator whose OpenCV is loaded.
 *
 * @throws OpenCvError when OpenCV cannot start
 * @throws RangeError for a board that cannot be
 */
export async function createCameraCalibrator(
  runtime: OpenCvRuntime,
  board: CharucoBoard,
): Promise<CameraCalibrator> {
  const calibrator = new CameraCalibrator(runtime, board);
  await runtime.run(() => undefined);
  return calibrator;
}

/** Collects views of a board that differ, and computes what the camera is like. */
export class CameraCalibrator {
  readonly #runtime: OpenCvRuntime;
  readonly #detector: BoardDetector;
  #size = { width: 0, height: 0 };
  #before: readonly BoardCorner[] = [];
  #views: CalibrationView[] = [];
  #result: CameraCalibration | undefined;

  /** @throws RangeError for a board that cannot be */
  constructor(runtime: OpenCvRuntime, board: CharucoBoard) {
    this.#runtime = runtime;
    this.#detector = new BoardDetector(runtime, board);
  }

  /** Looks at the next picture; another size of pictures begins again. */
  async look(picture: Picture): Promise<CalibrationLook> {
    const { width, height } = picture;
    if (width !== this.#size.width || height !== this.#size.height) this.reset();
    this.#size = { width, height };
    return this.#runtime.run((cv, keep) => {
      const { image, toPicture } = greyForDetection(cv, keep, picture);
      const corners = this.#detector
        .detect(cv, keep, image)
        .map((corner) => ({ ...corner, ...toPicture(corner) }));
      const isKept = this.#result === undefined && this.#take(cv, keep, corners);
      const problem = this.#result === undefined ? this.#problem(corners, isKept) : undefined;
      this.#before = corners;
      let failure: string | undefined;
      if (isKept && this.#views.length >= WANTED_VIEWS) {
        this.#result = this.#calibrate(cv, keep);
        if (this.#result === undefined) {
          this.#views = [];
          failure =
            'The views do not fit together. Start again with a board that is flat and whole.';
        }
      }
      return {
        corners: corners.map(({ id, x, y }) => ({
          id,
          x: (x + 0.5) / width,
          y: (y + 0.5) / height,
        })),
        isTaken: isKept,
        views: this.#views.length,
        hint:
          failure ??
          (this.#result
            ? 'The camera is calibrated.'
            : (problem ?? nextHint(this.#views, this.#size))),
        ...(this.#result && { calibration: this.#result }),
      };
    });
  }

  /** Forgets all views. */
  reset(): void {
    this.#views = [];
    this.#before = [];
    this.#result = undefined;
  }

  /** Frees what it holds. */
  dispose(): void {
    this.#detector.dispose();
  }

  #take(cv: OpenCv, keep: Keep, corners: readonly BoardCorner[]): boolean {
    if (corners.length < MIN_CORNERS || !isStill(corners, this.#before, this.#size)) return false;
    const view = { corners, normal: this.#normal(cv, keep, corners) };
    if (!isNewView(view, this.#views, this.#size)) return false;
    this.#views.push(view);
    return true;
  }

  /** Why a picture was no view, where the next hint does not say it better. */
  #problem(corners: readonly BoardCorner[], isKept: boolean): string | undefined {
    if (isKept) return undefined;
    if (corners.length === 0) return 'Show the board to the camera.';
    if (corners.length < MIN_CORNERS) return 'Show more of the board.';
    return isStill(corners, this.#before, this.#size) ? undefined : 'Hold the board still.';
  }

  /** Returns the normal of the board for an assumed camera, which suffices to distinguish tilts. */
  #normal(cv: OpenCv, keep: Keep, corners: readonly BoardCorner[]): Vector3Value {
    const { width, height } = this.#size;
    const { matrix, distortion } = cameraMats(cv, keep, assumedCalibration(width, height));
    const rotation = keep(new cv.Mat(3, 1, cv.CV_64FC1));
    const translation = keep(new cv.Mat(3, 1, cv.CV_64FC1));
    const { places, seen } = this.#points(cv, keep, corners);
    cv.solvePnP(places, seen, matrix, distortion, rotation, translation, false, ITERATIVE);
    const [x, y, z] = rotation.data64F as unknown as [number, number, number];
    return rotate(orientationOf(quaternionOfAxisAngle([x, y, z])), { x: 0, y: 0, z: 1 });
  }

  #points(cv: OpenCv, keep: Keep, corners: readonly BoardCorner[]): { places: CvMat; seen: CvMat } {
    const places = keep(new cv.Mat(corners.length, 1, cv.CV_32FC3));
    places.data32F.set(corners.flatMap(({ id }) => [...this.#detector.placeOf(id)]));
    const seen = keep(new cv.Mat(corners.length, 1, cv.CV_32FC2));
    seen.data32F.set(corners.flatMap(({ x, y }) => [x, y]));
    return { places, seen };
  }

  /** Zhang, A Flexible New Technique for Camera Calibration (2000), by OpenCV. */
  #calibrate(cv: OpenCv, keep: Keep): CameraCalibration | undefined {
    const places = keep(new cv.MatVector());
    const seen = keep(new cv.MatVector());
    for (const { corners } of this.#views) {
      const points = this.#points(cv, keep, corners);
      places.push_back(points.places);
      seen.push_back(points.seen);
    }
    const { width, height } = this.#size;
    const matrix = keep(new cv.Mat());
    const lens = keep(new cv.Mat());
    const errorPx = cv.calibrateCameraExtended(
      places,
      seen,
      new cv.Size(width, height),
      matrix,
      lens,
      keep(new cv.MatVector()),
      keep(new cv.MatVector()),
      keep(new cv.Mat()),
      keep(new cv.Mat()),
      keep(new cv.Mat()),
      FIX_K3,
    );
    const [fx, , cx, , fy, cy] = matrix.data64F as unknown as number[];
    const distortion = Array.from(lens.data64F.subarray(0, 5));
    const isCamera = [fx!, fy!].every(
      (focal) => focal > FOCAL.min * width && focal < FOCAL.max * width,
    );
    if (!isCamera || ![errorPx, cx, cy, ...distortion].every(Number.isFinite)) return undefined;
    return {
      width,
      height,
      fx: fx!,
      fy: fy!,
      cx: cx!,
      cy: cy!,
      distortion,
      reprojectionErrorPx: errorPx,
      views: this.#views.length,
    };
  }
}
