import { MAX_PIXELS, type PictureFile } from '@ubii/pictures';
import { decode } from 'jpeg-js';
import type { OwnPicture } from '../picture.ts';
import { orient } from './orient.ts';

/**
 * Decodes a JPEG file to RGB8, upright by its Exif orientation.
 *
 * @throws RangeError for damaged files
 */
export function decodeJpeg({ width, height, orientation, data: file }: PictureFile): OwnPicture {
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
