import { checkSize } from '@ubii/pictures';
import { CHANNELS, checkPicture, type OwnPicture, type Picture } from '../picture.ts';

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
