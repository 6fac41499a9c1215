import {
  MAX_PIXELS,
  checkSize,
  pictureFormatOf,
  readPictureFile,
  type PictureFile,
} from '@ubii/pictures';
import { decode } from 'jpeg-js';

import {
  CHANNELS,
  pictureOfImage2D,
  type OwnPicture,
  type Picture,
  type Image2DLike,
} from '../picture.ts';
import { decodePng } from './png.ts';

/**
 * Returns a picture upright.
 *
 * @param orientation of Exif 2.3, 4.6.4 A: where the first row and column are; 1 is upright
 */
export function orient(picture: Picture, orientation: number): OwnPicture {
  const { width, height, format } = picture;
  const from = picture.data;
  const isTurned = orientation >= 5;
  const [newWidth, newHeight] = isTurned ? [height, width] : [width, height];
  const isRightFirst = [2, 3, 7, 8].includes(orientation);
  const isBottomFirst = [3, 4, 6, 7].includes(orientation);
  const step = CHANNELS[format];
  const data = new Uint8Array(from.length);
  for (let y = 0; y < newHeight; y++) {
    for (let x = 0; x < newWidth; x++) {
      const [column, row] = isTurned ? [y, x] : [x, y];
      const fromX = isRightFirst ? width - 1 - column : column;
      const fromY = isBottomFirst ? height - 1 - row : row;
      const at = (fromY * width + fromX) * step;
      const to = (y * newWidth + x) * step;
      for (let channel = 0; channel < step; channel++) data[to + channel] = from[at + channel]!;
    }
  }
  return { width: newWidth, height: newHeight, format, data };
}

/**
 * Decodes a JPEG file to RGB8, upright by its Exif orientation.
 *
 * @throws RangeError for damaged files
 */
function decodeJpeg({ width, height, orientation, data: file }: PictureFile): OwnPicture {
  try {
    const { data } = decode(file, {
      useTArray: true,
      formatAsRGBA: false,
      tolerantDecoding: false,
      maxResolutionInMP: Math.ceil(MAX_PIXELS / 1e6),
    });
    return orient({ width, height, format: 'RGB8', data }, orientation);
  } catch {
    throw new RangeError('The JPEG file is damaged. Send the complete file.');
  }
}

/**
 * Reads the message `Image2D`, also when its data is a JPEG, PNG or WebP file.
 *
 * @throws RangeError that says what is wrong and what to send
 */
export async function readImage2D(image: Image2DLike): Promise<Picture> {
  const data = image.data ?? new Uint8Array();
  try {
    return pictureOfImage2D(image);
  } catch (error) {
    if (pictureFormatOf(data) === undefined) throw error;
  }
  return decodePicture(data);
}

/**
 * Decodes a JPEG, PNG or WebP file: by the browser where that is possible in a worker, which is faster,
 * otherwise by JavaScript, which does not decode WebP.
 *
 * @throws RangeError for damaged, animated, too large and unknown files [EX-98]
 */
export async function decodePicture(data: Uint8Array): Promise<Picture> {
  const hasBrowser =
    typeof createImageBitmap === 'function' && typeof OffscreenCanvas === 'function';
  if (!hasBrowser && pictureFormatOf(data) === 'WebP') {
    throw new RangeError('WebP files cannot be decoded here. Send JPEG or PNG.');
  }
  const file = readPictureFile(data);
  if (hasBrowser) return decodeByBrowser(file);
  return file.format === 'JPEG' ? decodeJpeg(file) : decodePng(file);
}

async function decodeByBrowser({ data: file, format }: PictureFile): Promise<Picture> {
  const bitmap = await createImageBitmap(new Blob([file.slice()]), {
    premultiplyAlpha: 'none',
  }).catch(() => {
    throw new RangeError(`The ${format} file is damaged. Send the complete file.`);
  });
  try {
    const { width, height } = bitmap;
    checkSize(width, height);
    const context = new OffscreenCanvas(width, height).getContext('2d', {
      willReadFrequently: true,
    })!;
    context.drawImage(bitmap, 0, 0);
    return { width, height, format: 'RGBA8', data: context.getImageData(0, 0, width, height).data };
  } finally {
    bitmap.close();
  }
}
