/** Formats of compressed pictures. */
export type PictureFileFormat = 'JPEG' | 'PNG' | 'WebP';

/**
 * Returns the format of a compressed picture by its first bytes; undefined for other data.
 *
 * Sources: ITU-T T.81 B.1.1.3 (JPEG), RFC 2083 3.1 (PNG), RFC 9649 2.4 (WebP).
 */
export function pictureFormatOf(data: ArrayLike<number>): PictureFileFormat | undefined {
  const has = (at: number, ...bytes: number[]): boolean =>
    bytes.every((byte, index) => data[at + index] === byte);
  if (has(0, 0xff, 0xd8, 0xff)) return 'JPEG';
  if (has(0, 0x89, 0x50, 0x4e, 0x47)) return 'PNG';
  if (has(0, 0x52, 0x49, 0x46, 0x46) && has(8, 0x57, 0x45, 0x42, 0x50)) return 'WebP';
  return undefined;
}

/** Properties of a picture file that are known before its pixels are decoded. */
export interface PictureHead {
  /** Pixels in a row, before the picture is turned upright. */
  readonly width: number;
  /** Rows, before the picture is turned upright. */
  readonly height: number;
  /** Exif orientation of a JPEG file, 1 (upright) to 8; 1 for other files. */
  readonly orientation: number;
  /** Length of the picture. What follows in the file does not belong to it. */
  readonly sizeBytes: number;
}

/**
 * Most pixels of a picture: 4096 × 4096, above the 12 megapixels (4032 × 3024) of most phones. With 4
 * channels it has 64 MiB, of which functions make a copy.
 */
export const MAX_PIXELS = 4096 * 4096;

/**
 * Most pixels of a file that the user of a page chooses on the own device, to be scaled down: 8192 × 8192, above the 50
 * megapixels of cameras of phones. Decoded, it has 256 MiB.
 */
export const MAX_CHOSEN_PIXELS = 4 * MAX_PIXELS;

/** Longest side in pixels: a panorama of 16 megapixels with an aspect ratio of 16 : 1. */
export const MAX_SIDE = 16_384;

/** Returns why a size is invalid or too large, and what is possible; undefined for other sizes. */
export function sizeProblem(
  width: number,
  height: number,
  maxPixels = MAX_PIXELS,
): string | undefined {
  const isSide = (side: number): boolean => Number.isInteger(side) && side > 0;
  if (!isSide(width) || !isSide(height)) {
    return `A picture cannot have ${width} × ${height} pixels. Width and height are whole numbers above 0.`;
  }
  if (width > MAX_SIDE || height > MAX_SIDE || width * height > maxPixels) {
    return `A picture of ${width} × ${height} pixels is too large. At most ${maxPixels / 2 ** 20} megapixels (2^20) and ${MAX_SIDE} pixels a side are possible.`;
  }
  return undefined;
}

/** @throws RangeError when the size is invalid or too large */
export function checkSize(width: number, height: number, maxPixels?: number): void {
  const problem = sizeProblem(width, height, maxPixels);
  if (problem !== undefined) throw new RangeError(problem);
}

export function damaged(format: PictureFileFormat): RangeError {
  return new RangeError(`The ${format} file is damaged. Send the complete file.`);
}

/**
 * @param what after "The JPEG file"
 * @param remedy what to do instead, without a full stop
 */
export function unsupported(format: PictureFileFormat, what: string, remedy: string): RangeError {
  return new RangeError(`The ${format} file ${what}, which is not supported. ${remedy}.`);
}
