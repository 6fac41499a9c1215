import type { CvArucoDetector, CvMat, OpenCv } from '../opencv/open-cv.ts';
import type { Keep, OpenCvRuntime } from '../opencv/open-cv-runtime.ts';
import type { Picture } from '../picture.ts';
import {
  assumedCalibration,
  type CameraCalibration,
  calibrationFor,
} from './camera-calibration.ts';
import { DEFAULT_DICTIONARY, markerDictionary, markerName } from './dictionaries.ts';
import { greyForDetection } from './grey-for-detection.ts';
import {
  cameraMats,
  type MarkerPose,
  markerPoses,
  type PixelPoint,
  projectedAxes,
} from './marker-pose.ts';
import { PoseMemory } from './pose-memory.ts';

export interface MarkerOptions {
  /** Default `aruco_4x4_50`. */
  readonly dictionary?: string;
  /** Side of the markers in metres, their black border included; default 0.05. */
  readonly sizeMetres?: number;
  /** Default: an assumed field of view, without distortion. */
  readonly calibration?: CameraCalibration;
  /** Of the longer side of the picture, without calibration; default 60. */
  readonly fieldOfViewDegrees?: number;
  /** Markers that are looked for; default and empty: all of the dictionary. */
  readonly ids?: readonly number[];
  /** Time over which poses are smoothed, milliseconds; default 0, none. */
  readonly smoothingMs?: number;
  /** Since the picture before, milliseconds. */
  readonly sinceMs?: number;
}

/** A marker in a picture. */
export interface TrackedMarker extends MarkerPose {
  /** Its number in the dictionary. */
  readonly id: number;
  /** Dictionary and id, such as `aruco_4x4_50:7`. */
  readonly name: string;
  /** Top left, top right, bottom right, bottom left of the print; 0 to 1 of width and height. */
  readonly corners: readonly PixelPoint[];
  /** Centre, and the ends of the axes x, y and z, each half a side long; 0 to 1 of width and height. */
  readonly axes: readonly PixelPoint[];
  readonly sizeMetres: number;
}

/** Corners are refined to parts of a pixel along the edges (OpenCV's `CORNER_REFINE_SUBPIX`). */
const REFINE_SUBPIXEL = 1;
const MAX_SIZE_METRES = 100;

/**
 * A tracker whose OpenCV is loaded.
 *
 * @throws OpenCvError when OpenCV cannot start
 */
export async function createMarkerTracker(runtime: OpenCvRuntime): Promise<MarkerTracker> {
  await runtime.run(() => undefined);
  return new MarkerTracker(runtime);
}

/** Finds the markers of pictures, one after the other, with their poses. Holds memory of OpenCV until it is disposed. */
export class MarkerTracker {
  readonly #runtime: OpenCvRuntime;
  readonly #memory = new PoseMemory();
  #detector: { cv: OpenCv; dictionary: string; native: CvArucoDetector } | undefined;

  constructor(runtime: OpenCvRuntime) {
    this.#runtime = runtime;
  }

  /**
   * Finds all markers of one picture, ordered by id.
   *
   * @throws RangeError for options that are wrong, and a calibration that does not fit
   */
  async track(picture: Picture, options: MarkerOptions = {}): Promise<TrackedMarker[]> {
    const {
      dictionary = DEFAULT_DICTIONARY,
      sizeMetres = 0.05,
      ids = [],
      smoothingMs = 0,
      sinceMs = Infinity,
    } = options;
    const { count } = markerDictionary(dictionary);
    const unknown = ids.find((id) => !Number.isInteger(id) || id < 0 || id >= count);
    if (unknown !== undefined) {
      throw new RangeError(
        `${dictionary} has no marker ${unknown}. Its ids are 0 to ${count - 1}.`,
      );
    }
    if (!(sizeMetres > 0 && sizeMetres <= MAX_SIZE_METRES)) {
      throw new RangeError(
        `The size of a marker is above 0 and at most ${MAX_SIZE_METRES} metres.`,
      );
    }
    const { width, height } = picture;
    const calibration =
      options.calibration === undefined
        ? assumedCalibration(width, height, options.fieldOfViewDegrees)
        : calibrationFor(options.calibration, width, height);
    this.#memory.begin(sinceMs);
    const found = await this.#runtime.run((cv, keep) => {
      const { image, toPicture } = greyForDetection(cv, keep, picture);
      const camera = cameraMats(cv, keep, calibration);
      return this.#detect(cv, keep, image, dictionary)
        .filter(({ id }) => ids.length === 0 || ids.includes(id))
        .flatMap(({ id, corners }) => {
          const points = corners.map(toPicture);
          const pose = this.#memory.choose(
            `${dictionary}:${id}`,
            markerPoses(cv, keep, points, sizeMetres, camera),
            smoothingMs,
          );
          if (pose === undefined) return [];
          const axes = projectedAxes(cv, keep, pose, sizeMetres / 2, camera);
          return [{ id, points, pose, axes }];
        });
    });
    const toUnit = ({ x, y }: PixelPoint): PixelPoint => ({
      x: (x + 0.5) / width,
      y: (y + 0.5) / height,
    });
    return found
      .sort((a, b) => a.id - b.id)
      .map(({ id, points, pose, axes }) => ({
        ...pose,
        id,
        name: markerName(dictionary, id),
        corners: points.map(toUnit),
        axes: axes.map(toUnit),
        sizeMetres,
      }));
  }

  /** Frees what it holds. */
  dispose(): void {
    // Of an OpenCV that stopped, nothing can be deleted
    if (this.#detector && this.#runtime.owns(this.#detector.cv)) this.#detector.native.delete();
    this.#detector = undefined;
  }

  #detect(cv: OpenCv, keep: Keep, image: CvMat, dictionary: string) {
    const corners = keep(new cv.MatVector());
    const ids = keep(new cv.Mat());
    const rejected = keep(new cv.MatVector());
    this.#nativeDetector(cv, keep, dictionary).detectMarkers(image, corners, ids, rejected);
    const numbers = Array.from(ids.data32S.subarray(0, ids.rows * ids.cols));
    return numbers.map((id, index) => {
      const [x0, y0, x1, y1, x2, y2, x3, y3] = keep(corners.get(index)).data32F;
      return {
        id,
        corners: [
          { x: x0!, y: y0! },
          { x: x1!, y: y1! },
          { x: x2!, y: y2! },
          { x: x3!, y: y3! },
        ],
      };
    });
  }

  /** The detector of the dictionary, made again for another dictionary or another OpenCV. */
  #nativeDetector(cv: OpenCv, keep: Keep, dictionary: string): CvArucoDetector {
    const known = this.#detector;
    if (known?.cv === cv && known.dictionary === dictionary) return known.native;
    this.dispose();
    const parameters = keep(new cv.aruco_DetectorParameters());
    parameters.cornerRefinementMethod = REFINE_SUBPIXEL;
    const native = new cv.aruco_ArucoDetector(
      keep(cv.getPredefinedDictionary(markerDictionary(dictionary).opencv)),
      parameters,
      keep(new cv.aruco_RefineParameters(10, 3, true)),
    );
    this.#detector = { cv, dictionary, native };
    return native;
  }
}
