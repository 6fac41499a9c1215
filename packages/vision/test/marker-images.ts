import { encode } from 'jpeg-js';
import { assumedCalibration, type CameraCalibration } from '../src/markers/camera-calibration.ts';
import type { Picture } from '../src/picture.ts';
import { markerDictionary, markerCells } from '../src/markers/dictionaries.ts';
import { convertPicture } from '../src/image-tools/convert-picture.ts';
import { DEFAULT_BOARD } from '../src/markers/charuco-board.ts';
import { boardBrightness } from './board-print.ts';
import { cellPrint, renderScene, turned } from './marker-scene.ts';

export { createOpenCvRuntime } from './open-cv-set.ts';

/** Side of the markers in `markerImage`, metres. */
export const MARKER_IMAGE_SIZE = 0.08;

/**
 * A picture of two markers, `aruco_4x4_50:7` upright at (-0.08, 0.02, -0.5) and `aruco_4x4_50:23` at
 * (0.09, -0.02, -0.45) turned by 30 degrees about y, by a camera of 60 degrees without distortion; 640 × 480.
 */
export function markerImage(): Picture {
  const print = (id: number) => markerCells(markerDictionary('aruco_4x4_50'), id);
  const cell = MARKER_IMAGE_SIZE / print(0).length;
  const camera = assumedCalibration(640, 480);
  return renderScene(camera, [
    cellPrint(print(7), cell, {
      position: { x: -0.08, y: 0.02, z: -0.5 },
      orientation: turned(0, 0),
    }),
    cellPrint(print(23), cell, {
      position: { x: 0.09, y: -0.02, z: -0.45 },
      orientation: turned(0, 30),
    }),
  ]);
}

/** The same as a JPEG file. */
export function markerImageFile(): Uint8Array {
  return jpegFile(markerImage());
}

/** A picture as a JPEG file. */
export function jpegFile(picture: Picture): Uint8Array {
  const { width, height, data } = convertPicture(picture, 'RGBA8');
  return new Uint8Array(encode({ width, height, data }, 90).data);
}

/** Poses of a board that calibrate a camera: metres and degrees about x and y. */
export const BOARD_POSES: readonly (readonly [
  x: number,
  y: number,
  z: number,
  tiltX: number,
  tiltY: number,
])[] = [
  [0, 0, -0.42, 0, 0],
  [0, 0, -0.4, 0, -30],
  [0.02, 0, -0.4, 0, 30],
  [0, 0.01, -0.42, -30, 0],
  [0, -0.01, -0.42, 30, 0],
  [-0.13, 0.03, -0.45, 10, 25],
  [0.13, -0.03, -0.45, -10, -25],
  [-0.1, 0.06, -0.5, -25, 20],
  [0.1, 0.06, -0.5, -25, -20],
  [0.1, -0.07, -0.5, 25, -20],
  [-0.1, -0.07, -0.5, 25, 20],
  [0.02, 0.02, -0.32, 15, 15],
  [0.05, 0.01, -0.6, 30, -30],
  [-0.05, 0.05, -0.36, -20, 30],
];

/** A picture of the default board as a camera sees it. */
export function boardImage(
  camera: CameraCalibration,
  [x, y, z, tiltX, tiltY]: (typeof BOARD_POSES)[number],
): Picture {
  const print = {
    position: { x, y, z },
    orientation: turned(tiltX, tiltY),
    brightness: boardBrightness(DEFAULT_BOARD),
  };
  return renderScene(camera, [print], { noise: 3 });
}
