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
