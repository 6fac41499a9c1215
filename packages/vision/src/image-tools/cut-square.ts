import { checkSize } from '@ubii/pictures';
import { CHANNELS, checkPicture, type OwnPicture, type Picture } from '../picture.ts';

/** A square in a picture that may be turned and may reach beyond its borders. */
export interface TurnedSquare {
  /** Middle, in pixels of the picture. */
  readonly x: number;
  readonly y: number;
  /** Pixels of a side. */
  readonly side: number;
  /** Radians from the picture's x axis to that of the square, clockwise as seen. */
  readonly angle: number;
}

/**
 * Returns a turned square of a picture, upright, by bilinear interpolation. What lies outside of the
 * picture is 0.
 *
 * @param size pixels of a side of the new picture
 * @throws RangeError when the picture or the size is invalid
 */
export function cutSquare(picture: Picture, square: TurnedSquare, size: number): OwnPicture {
  checkPicture(picture);
  checkSize(size, size);
  const { width, height, data: from } = picture;
  const step = CHANNELS[picture.format];
  const data = new Uint8Array(size * size * step);
  let to = 0;
  for (let row = 0; row < size; row++) {
    for (let column = 0; column < size; column++, to += step) {
      const place = placeInPicture(square, (column + 0.5) / size, (row + 0.5) / size);
      // From the middle of the first pixel on.
      const [x, y] = [place.x - 0.5, place.y - 0.5];
      if (!(x > -1 && y > -1 && x < width && y < height)) continue;
      const left = Math.max(0, Math.floor(x));
      const top = Math.max(0, Math.floor(y));
      const across = Math.max(0, x - left);
      const down = Math.max(0, y - top);
      const first = (top * width + left) * step;
      const right = left + 1 < width ? step : 0;
      const below = top + 1 < height ? width * step : 0;
      for (let channel = 0; channel < step; channel++) {
        const at = first + channel;
        const a = from[at]! + (from[at + right]! - from[at]!) * across;
        const b = from[at + below]! + (from[at + below + right]! - from[at + below]!) * across;
        data[to + channel] = a + (b - a) * down + 0.5;
      }
    }
  }
  return { width: size, height: size, format: picture.format, data };
}

/** Returns where a place of the square (0 to 1 along its axes) is in the picture, in pixels. */
export function placeInPicture(
  { x, y, side, angle }: TurnedSquare,
  along: number,
  down: number,
): { x: number; y: number } {
  const [dx, dy] = [(along - 0.5) * side, (down - 0.5) * side];
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  return { x: x + dx * cos - dy * sin, y: y + dx * sin + dy * cos };
}
