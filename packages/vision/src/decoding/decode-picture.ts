import {
  checkSize,
  compressionOf,
  type Image2DLike,
  type Picture,
  type PictureFileFormat,
  pictureOfImage2D,
} from '../picture.ts';
import { decodeJpeg, readJpegHead } from './jpeg.ts';
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
    if (compressionOf(data) === undefined) throw error;
  }
  return decodePicture(data);
}

/**
 * Decodes a JPEG, PNG or WebP file: by the browser where that is possible in a worker, which is faster,
 * otherwise by JavaScript, which does not decode WebP.
 *
 * @throws RangeError for damaged, too large and unknown files
 */
export async function decodePicture(file: Uint8Array): Promise<Picture> {
  const format = compressionOf(file);
  if (format === undefined) {
    throw new RangeError('The file is not a picture. Send JPEG, PNG or WebP.');
  }
  if (typeof createImageBitmap === 'function' && typeof OffscreenCanvas === 'function') {
    return decodeByBrowser(file, format);
  }
  if (format === 'WebP') {
    throw new RangeError('WebP files cannot be decoded here. Send JPEG or PNG.');
  }
  return format === 'JPEG' ? decodeJpeg(file) : decodePng(file);
}

async function decodeByBrowser(file: Uint8Array, format: PictureFileFormat): Promise<Picture> {
  checkSizeInFile(file, format);
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

/** A small file may claim a size that fills the memory; browsers limit that of WebP (16 383 pixels a side). */
function checkSizeInFile(file: Uint8Array, format: PictureFileFormat): void {
  if (format === 'JPEG') {
    const { width, height } = readJpegHead(file);
    checkSize(width, height);
  } else if (format === 'PNG' && file.length >= 24) {
    const view = new DataView(file.buffer, file.byteOffset, file.byteLength);
    checkSize(view.getUint32(16), view.getUint32(20));
  }
}
