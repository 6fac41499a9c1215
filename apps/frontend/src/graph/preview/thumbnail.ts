import { sizeProblem } from '@ubii/pictures';
import { isCompressedImage, type Image2D } from '@ubii/proto';
import { pictureBitmap } from '../../formats/picture-bitmap.ts';
import { rgbaPixels } from '../../topics/viewers/picture/image-pixels.ts';

/** Largest width, pixels: the drawn width on a screen of double density. */
export const THUMB_WIDTH = 320;

/**
 * Shrinks a raw picture by skipping pixels, which suffices for thumbnails. Returns pictures whose data is too short for
 * their size unchanged.
 */
export function shrunk(image: Image2D, maxWidth = THUMB_WIDTH): Image2D {
  const { width, height, data } = image;
  const step = Math.ceil(width / maxWidth);
  const channels = data.length / (width * height);
  if (step <= 1 || !Number.isInteger(channels)) return image;
  const [w, h] = [Math.floor(width / step), Math.max(1, Math.floor(height / step))];
  const small = new Uint8Array(w * h * channels);
  let to = 0;
  for (let y = 0; y < h; y++) {
    for (let x = 0; x < w; x++) {
      const from = (y * step * width + x * step) * channels;
      for (let channel = 0; channel < channels; channel++) small[to++] = data[from + channel]!;
    }
  }
  return { ...image, width: w, height: h, data: small };
}

/** Converts a picture to a thumbnail that a canvas can draw; encoded pictures are decoded off the main thread. */
export async function thumbnail(image: Image2D): Promise<ImageBitmap | ImageData | undefined> {
  if (isCompressedImage(image.data)) {
    return pictureBitmap(image.data, { resizeWidth: THUMB_WIDTH, resizeQuality: 'low' });
  }
  if (sizeProblem(image.width, image.height) !== undefined) return undefined;
  const small = shrunk(image);
  const pixels = rgbaPixels(small);
  return pixels && new ImageData(pixels, small.width, small.height);
}
