import { convertPicture } from './image-tools/convert-picture.ts';
import { scalePicture } from './image-tools/crop-and-scale.ts';
import { checkPicture, type Picture } from './picture.ts';

/** Input of a model: the picture at the top left, the rest black. */
export interface ModelInput {
  /** Pixels in a row of the input. */
  readonly width: number;
  readonly height: number;
  /** Red, green and blue of each pixel, 0 to 255. */
  readonly rgb: Uint8Array;
  /** The part of the input that the picture covers. */
  readonly pictureWidth: number;
  readonly pictureHeight: number;
}

/**
 * Fits a picture into the input of a model and keeps its aspect ratio.
 *
 * @param longSide pixels of the longer side
 * @param step both sides are multiples of this; the same as `longSide` for a square input
 * @throws RangeError when the picture is invalid
 */
export function fitModelInput(picture: Picture, longSide: number, step: number): ModelInput {
  checkPicture(picture);
  const scale = longSide / Math.max(picture.width, picture.height);
  const pictureWidth = Math.max(1, Math.round(picture.width * scale));
  const pictureHeight = Math.max(1, Math.round(picture.height * scale));
  const fitted = convertPicture(scalePicture(picture, pictureWidth, pictureHeight), 'RGB8');
  const width = Math.ceil(pictureWidth / step) * step;
  const height = Math.ceil(pictureHeight / step) * step;
  if (width === pictureWidth && height === pictureHeight) {
    return { width, height, rgb: fitted.data, pictureWidth, pictureHeight };
  }
  const rgb = new Uint8Array(width * height * 3);
  for (let row = 0; row < pictureHeight; row++) {
    const line = fitted.data.subarray(row * pictureWidth * 3, (row + 1) * pictureWidth * 3);
    rgb.set(line, row * width * 3);
  }
  return { width, height, rgb, pictureWidth, pictureHeight };
}
