import { sizeProblem } from '@ubii/pictures';
import { Image2DDataFormat, isCompressedImage, type Image2D } from '@ubii/proto';
import { pictureBitmap } from '../../../formats/picture-bitmap.ts';

/**
 * Converts a raw picture to RGBA for a canvas, row by row from the top left.
 * @returns `undefined` when there are fewer bytes than its size needs, and for more pixels than a picture has [EX-98]
 */
export function rgbaPixels({
  width,
  height,
  dataFormat,
  data,
}: Image2D): Uint8ClampedArray<ArrayBuffer> | undefined {
  const channels = CHANNELS[dataFormat];
  const count = width * height;
  if (!channels || sizeProblem(width, height) !== undefined) return undefined;
  if (data.length < count * channels) return undefined;
  const pixels = new Uint8ClampedArray(count * 4);
  if (channels === 4) {
    pixels.set(data.subarray(0, count * 4));
    return pixels;
  }
  for (let i = 0; i < count; i++) {
    const from = i * channels;
    pixels[i * 4] = data[from]!;
    pixels[i * 4 + 1] = data[channels === 1 ? from : from + 1]!;
    pixels[i * 4 + 2] = data[channels === 1 ? from : from + 2]!;
    pixels[i * 4 + 3] = 255;
  }
  return pixels;
}

const CHANNELS: Readonly<Record<number, number>> = {
  [Image2DDataFormat.GRAY8]: 1,
  [Image2DDataFormat.RGB8]: 3,
  [Image2DDataFormat.RGBA8]: 4,
};

/** Converts a picture to a source that a canvas can draw. The caller closes a bitmap. */
export async function toDrawable(image: Image2D): Promise<ImageBitmap | ImageData | undefined> {
  if (isCompressedImage(image.data)) {
    return pictureBitmap(image.data);
  }
  const pixels = rgbaPixels(image);
  return pixels && new ImageData(pixels, image.width, image.height);
}
