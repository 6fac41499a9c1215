import { checkSize, pictureFormatOf, type PictureFile, readPictureFile } from '@ubii/pictures';
import { type Image2DLike, type Picture, pictureOfImage2D } from '../picture.ts';
import { decodeJpeg } from './jpeg.ts';
import { decodePng } from './png.ts';

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
