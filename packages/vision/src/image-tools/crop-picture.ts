import { CHANNELS, checkPicture, type OwnPicture, type Picture } from '../picture.ts';

/** A part of a picture, in pixels; x and y are those of its top left corner. */
export interface Rectangle {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/**
 * Returns a part of a picture: the pixels that the rectangle touches. What lies outside of the
 * picture is left out.
 *
 * @throws RangeError when the picture is invalid or the rectangle lies outside of it
 */
export function cropPicture(picture: Picture, rectangle: Rectangle): OwnPicture {
  checkPicture(picture);
  const left = Math.max(0, Math.floor(rectangle.x));
  const top = Math.max(0, Math.floor(rectangle.y));
  const right = Math.min(picture.width, Math.ceil(rectangle.x + rectangle.width));
  const bottom = Math.min(picture.height, Math.ceil(rectangle.y + rectangle.height));
  const [width, height] = [right - left, bottom - top];
  if (!(width > 0 && height > 0)) {
    throw new RangeError(
      `The part at ${rectangle.x}, ${rectangle.y} of ${rectangle.width} × ${rectangle.height} pixels is outside of the picture (${picture.width} × ${picture.height}).`,
    );
  }
  const step = CHANNELS[picture.format];
  const data = new Uint8Array(width * height * step);
  for (let row = 0; row < height; row++) {
    const from = ((top + row) * picture.width + left) * step;
    data.set(picture.data.subarray(from, from + width * step), row * width * step);
  }
  return { width, height, format: picture.format, data };
}
