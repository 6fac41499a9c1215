import { checkSize } from '@ubii/pictures';

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

/**
 * Returns a picture of another size: bilinear, with pixels as areas (the middle of the first one is
 * at 0.5). When it shrinks to half or less, blocks of whole pixels are averaged first, so that fine
 * patterns become their mean instead of noise.
 *
 * @param width new pixels in a row
 * @param height new rows
 * @throws RangeError when the picture or the size is invalid
 */
export function scalePicture(picture: Picture, width: number, height: number): OwnPicture {
  checkPicture(picture);
  checkSize(width, height);
  const blockWidth = Math.max(1, Math.floor(picture.width / width));
  const blockHeight = Math.max(1, Math.floor(picture.height / height));
  const isShrunk = blockWidth > 1 || blockHeight > 1;
  const source = isShrunk ? averageBlocks(picture, blockWidth, blockHeight) : picture;
  const step = CHANNELS[picture.format];
  const columns = samplesOf(width, picture.width / width / blockWidth, source.width, step);
  const rows = samplesOf(height, picture.height / height / blockHeight, source.height, 1);
  const data = new Uint8Array(width * height * step);
  const from = source.data;
  let to = 0;
  for (let y = 0; y < height; y++) {
    const top = rows.first[y]! * source.width * step;
    const bottom = rows.second[y]! * source.width * step;
    const share = rows.share[y]!;
    for (let x = 0; x < width; x++) {
      const left = columns.first[x]!;
      const right = columns.second[x]!;
      const across = columns.share[x]!;
      for (let channel = 0; channel < step; channel++) {
        const upper = from[top + left + channel]!;
        const lower = from[bottom + left + channel]!;
        const a = upper + (from[top + right + channel]! - upper) * across;
        const b = lower + (from[bottom + right + channel]! - lower) * across;
        data[to++] = a + (b - a) * share + 0.5;
      }
    }
  }
  return { width, height, format: picture.format, data };
}

/** For each new pixel the two old ones it lies between, as offsets, and how near it is to the second. */
function samplesOf(
  length: number,
  ratio: number,
  sourceLength: number,
  step: number,
): { first: Int32Array; second: Int32Array; share: Float32Array } {
  const first = new Int32Array(length);
  const second = new Int32Array(length);
  const share = new Float32Array(length);
  for (let index = 0; index < length; index++) {
    const at = Math.min(sourceLength - 1, Math.max(0, (index + 0.5) * ratio - 0.5));
    const before = Math.floor(at);
    first[index] = before * step;
    second[index] = Math.min(sourceLength - 1, before + 1) * step;
    share[index] = at - before;
  }
  return { first, second, share };
}

/**
 * Means of blocks of pixels. Columns and rows that fill no block are left out: half a new pixel of
 * the right and lower edge at most.
 */
function averageBlocks(picture: Picture, blockWidth: number, blockHeight: number): OwnPicture {
  const step = CHANNELS[picture.format];
  const width = Math.floor(picture.width / blockWidth);
  const height = Math.floor(picture.height / blockHeight);
  const data = new Uint8Array(width * height * step);
  const sums = new Uint32Array(width * step);
  const area = blockWidth * blockHeight;
  for (let y = 0; y < height; y++) {
    sums.fill(0);
    for (let row = 0; row < blockHeight; row++) {
      let from = (y * blockHeight + row) * picture.width * step;
      for (let x = 0; x < width; x++, from += blockWidth * step) {
        for (let channel = 0; channel < step; channel++) {
          let sum = 0;
          const end = from + blockWidth * step;
          for (let at = from + channel; at < end; at += step) sum += picture.data[at]!;
          sums[x * step + channel]! += sum;
        }
      }
    }
    const start = y * width * step;
    for (let index = 0; index < sums.length; index++) {
      data[start + index] = sums[index]! / area + 0.5;
    }
  }
  return { width, height, format: picture.format, data };
}
