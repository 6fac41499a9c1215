import type { CalibrationLook } from '../markers/camera-calibrator.ts';
import type { TrackedMarker } from '../markers/marker-tracker.ts';
import type { QuaternionValue, Vector3Value } from '../markers/rotations.ts';
import type { Object2DListValue } from './object2d-list.ts';

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
