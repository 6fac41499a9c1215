import { readPictureFile, type PictureFile } from '@ubii/pictures';
import { MAX_PHOTO_BYTES, MAX_PHOTO_SIDE } from './photo.ts';

/**
 * Returns a JPEG file that the big screen may decode: small in bytes, and in pixels, of which a small file may state many
 * [EX-98]. Undefined for other data.
 */
export function photoFile(data: Uint8Array): PictureFile | undefined {
  if (data.length > MAX_PHOTO_BYTES) return undefined;
  try {
    const file = readPictureFile(data);
    const isSmall = Math.max(file.width, file.height) <= MAX_PHOTO_SIDE;
    return file.format === 'JPEG' && isSmall ? file : undefined;
  } catch {
    return undefined;
  }
}
