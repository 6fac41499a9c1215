import { readFileSync } from 'node:fs';
import { decode } from 'jpeg-js';
import type { Box } from '../src/detection/detector.ts';
import type { Picture } from '../src/picture.ts';

// Without TensorFlow.js, of which a thread can have one.
export { convertPicture } from '../src/image-tools/convert-picture.ts';
export { scalePicture } from '../src/image-tools/crop-and-scale.ts';

/** A photograph, and what a person sees in it. */
export interface Photo {
  readonly file: string;
  /** The main objects of COCO's classes; boxes measured with a ruler on the picture. */
  readonly objects: readonly { readonly class: string; readonly box: Box }[];
}

const boxOf = (left: number, top: number, right: number, bottom: number): Box => ({
  x: left,
  y: top,
  width: right - left,
  height: bottom - top,
});

/** The shipped photographs. What else a detector may call right is not in the list, as the saucer. */
export const PHOTOS: readonly Photo[] = [
  // From the sleeve at the left to the one behind the helmet; cut by the lower border.
  {
    file: 'astronaut.jpg',
    objects: [{ class: 'person', box: boxOf(0.04, 0.03, 0.72, 1) }],
  },
  // Only the face and an ear; fur reaches the left, upper and lower border.
  { file: 'chelsea.jpg', objects: [{ class: 'cat', box: boxOf(0, 0, 0.89, 1) }] },
  // From the rim to the foot of the cup, handle included.
  { file: 'coffee.jpg', objects: [{ class: 'cup', box: boxOf(0.285, 0.04, 0.685, 0.77) }] },
  // The man; his glove at the camera is the right end.
  { file: 'camera.jpg', objects: [{ class: 'person', box: boxOf(0, 0.12, 0.64, 1) }] },
];

/** The JPEG file of a photograph. */
export function photoFile(file: string): Uint8Array {
  return new Uint8Array(readFileSync(new URL(`../photos/${file}`, import.meta.url)));
}

/** Reads a photograph as RGB8. */
export function readPhoto(file: string): Picture {
  const bytes = photoFile(file);
  const { width, height, data } = decode(bytes, { useTArray: true, formatAsRGBA: false });
  return { width, height, format: 'RGB8', data };
}
