import { encode } from 'jpeg-js';
import { assumedCalibration } from '../src/markers/camera-calibration.ts';
import { markerDictionary } from '../src/markers/dictionaries.ts';
import { markerCells } from '../src/markers/marker-cells.ts';
import { convertPicture } from '../src/image-tools/convert-picture.ts';
import { cellPrint, renderScene, turned } from './marker-scene.ts';

/** Side of the markers in `markerImage`, metres. */
export const MARKER_IMAGE_SIZE = 0.08;

/**
 * A picture of two markers, `aruco_4x4_50:7` upright at (-0.08, 0.02, -0.5) and `aruco_4x4_50:23` at
 * (0.09, -0.02, -0.45) turned by 30 degrees about y, by a camera of 60 degrees without distortion; 640 × 480.
 */
export function markerImage() {
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
  const { width, height, data } = convertPicture(markerImage(), 'RGBA8');
  return new Uint8Array(encode({ width, height, data }, 90).data);
}
