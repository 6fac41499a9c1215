import type { Detection } from '../detection/detector.ts';
import type { CalibrationLook } from '../markers/camera-calibrator.ts';
import type { TrackedMarker } from '../markers/marker-tracker.ts';
import type { QuaternionValue, Vector3Value } from '../markers/rotations.ts';

/** The fields of the message `Object2D` that are set here. */
export interface Object2DValue {
  /** Class of an object, or name of a keypoint. */
  readonly id: string;
  /** Top left corner of a box, or a point; 0 to 1 of the picture's width and height. */
  readonly pose: { readonly position: { readonly x: number; readonly y: number } };
  /** Width and height, 0 to 1; points have none. */
  readonly size?: { readonly x: number; readonly y: number };
  /** JSON text: `{ "score": 0.87 }`. */
  readonly userDataJson: string;
}

/** A value of the data format `object2DList`. */
export interface Object2DListValue {
  readonly elements: readonly Object2DValue[];
}

/** Converts detections to the message that clients draw over the picture. */
export function object2DListOfDetections(detections: readonly Detection[]): Object2DListValue {
  return {
    elements: detections.map(({ class: id, score, box: { x, y, width, height } }) => ({
      id,
      pose: { position: { x, y } },
      size: { x: width, y: height },
      userDataJson: scoreJson(score),
    })),
  };
}

/**
 * Converts keypoints to the message that clients draw over the picture.
 *
 * @param minScore keypoints with a lower score are left out, 0 to 1; keypoints without a score are kept
 */
export function object2DListOfKeypoints(
  keypoints: readonly { name: string; x: number; y: number; score?: number }[],
  minScore = 0,
): Object2DListValue {
  return {
    elements: keypoints
      .filter(({ score = 1 }) => score >= minScore)
      .map(({ name, x, y, score = 1 }) => ({
        id: name,
        pose: { position: { x, y } },
        userDataJson: scoreJson(score),
      })),
  };
}

/** Two digits: more are noise, and the text is sent with every picture. */
function scoreJson(score: number): string {
  return JSON.stringify({ score: Math.round(score * 100) / 100 });
}

/** The fields of the message `Object3D` that are set here. */
export interface Object3DValue {
  readonly id: string;
  readonly pose: { readonly position: Vector3Value; readonly quaternion: QuaternionValue };
  /** Metres along its own axes. */
  readonly size: Vector3Value;
  readonly userDataJson: string;
}

/** Converts markers to poses. `userDataJson`: `{ "errorPx": 0.12 }`. */
export function object3DListOfMarkers(markers: readonly TrackedMarker[]): {
  readonly elements: readonly Object3DValue[];
} {
  return {
    elements: markers.map(({ name, position, orientation, sizeMetres, errorPx }) => ({
      id: name,
      pose: { position, quaternion: orientation },
      size: { x: sizeMetres, y: sizeMetres, z: 0 },
      userDataJson: JSON.stringify({ errorPx: rounded(errorPx, 100) }),
    })),
  };
}

/**
 * Converts markers to what clients draw over the picture: a box around each, and in `userDataJson` its
 * `corners` (top left, top right, bottom right, bottom left of the print) and `axes` (centre, ends of x, y, z).
 */
export function object2DListOfMarkers(markers: readonly TrackedMarker[]): Object2DListValue {
  const pairs = (points: TrackedMarker['corners']): number[][] =>
    points.map(({ x, y }) => [rounded(x, 10_000), rounded(y, 10_000)]);
  return {
    elements: markers.map(({ name, corners, axes }) => {
      const xs = corners.map(({ x }) => x);
      const ys = corners.map(({ y }) => y);
      const [left, top] = [Math.min(...xs), Math.min(...ys)];
      return {
        id: name,
        pose: { position: { x: left, y: top } },
        size: { x: Math.max(...xs) - left, y: Math.max(...ys) - top },
        userDataJson: JSON.stringify({ corners: pairs(corners), axes: pairs(axes) }),
      };
    }),
  };
}

/**
 * Converts corners of a board to what clients draw over the picture. `userDataJson`: `{ "corner": 3 }`.
 * Ids are empty: names of 24 points would cover the board.
 */
export function object2DListOfCorners(corners: CalibrationLook['corners']): Object2DListValue {
  return {
    elements: corners.map(({ id, x, y }) => ({
      id: '',
      pose: { position: { x, y } },
      userDataJson: JSON.stringify({ corner: id }),
    })),
  };
}

const rounded = (value: number, parts: number): number => Math.round(value * parts) / parts;
