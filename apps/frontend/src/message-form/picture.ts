import { MAX_CHOSEN_PIXELS } from '@ubii/pictures';
import type { JsonObject } from '@ubii/proto';
import { pictureBitmap } from '../formats/picture-bitmap.ts';
import { base64Of } from './base64.ts';

/** Longer side to which larger pictures are scaled down, pixels. */
const MAX_SIDE = 1280;
/** Largest file that is sent unchanged, bytes. */
const MAX_AS_IS = 300_000;
const QUALITY = 0.85;

/** Encodes a drawn picture as JPEG; returns the members of an Image2D. */
export async function pictureOf(
  source: CanvasImageSource,
  width: number,
  height: number,
): Promise<JsonObject> {
  const scale = Math.min(1, MAX_SIDE / Math.max(width, height));
  const canvas = document.createElement('canvas');
  canvas.width = Math.max(1, Math.round(width * scale));
  canvas.height = Math.max(1, Math.round(height * scale));
  canvas.getContext('2d')!.drawImage(source, 0, 0, canvas.width, canvas.height);
  const blob = await new Promise<Blob | null>((resolve) =>
    canvas.toBlob(resolve, 'image/jpeg', QUALITY),
  );
  if (!blob) throw new Error('The browser could not encode the picture. Choose another one.');
  return members(canvas.width, canvas.height, blob);
}

/**
 * Returns the members of an Image2D: the file itself if it is small; otherwise re-encoded as JPEG.
 *
 * @throws RangeError that says why the file is refused [EX-98], or the error of the browser, which has no reason
 */
export async function pictureOfFile(file: File): Promise<JsonObject> {
  const bytes = new Uint8Array(await file.arrayBuffer());
  const bitmap = await pictureBitmap(bytes, undefined, MAX_CHOSEN_PIXELS);
  const { width, height } = bitmap;
  const isAsIs = file.size <= MAX_AS_IS && Math.max(width, height) <= MAX_SIDE;
  const picture = isAsIs ? members(width, height, file) : pictureOf(bitmap, width, height);
  return picture.finally(() => bitmap.close());
}

async function members(width: number, height: number, blob: Blob): Promise<JsonObject> {
  const data = base64Of(new Uint8Array(await blob.arrayBuffer()));
  return { width, height, dataFormat: 'RGB8', data };
}
