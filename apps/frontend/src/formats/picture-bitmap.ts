import { readPictureFile } from '@ubii/pictures';

/** Files that pages decode, for file inputs: systems convert what they have in another format, such as HEIC. */
export const PICTURE_TYPES = 'image/jpeg,image/png,image/webp';

/**
 * Decodes a picture file, after its head was read [EX-98]. The caller closes the bitmap.
 *
 * @param maxPixels width × height. @default those of pictures in topics
 * @throws RangeError that says why the file is refused, or the error of the browser, which has no reason
 */
export async function pictureBitmap(
  file: Uint8Array,
  options?: ImageBitmapOptions,
  maxPixels?: number,
): Promise<ImageBitmap> {
  const { data } = readPictureFile(file, maxPixels);
  return createImageBitmap(new Blob([data as Uint8Array<ArrayBuffer>]), options);
}

/** Returns why a picture file is refused; undefined when a browser may decode it [EX-98]. */
export function pictureFileProblem(file: Uint8Array): string | undefined {
  try {
    readPictureFile(file);
    return undefined;
  } catch (error) {
    return error instanceof Error ? error.message : String(error);
  }
}
