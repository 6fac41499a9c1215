import { sizeProblem } from '@ubii/pictures';
import { Image2DDataFormat, isCompressedImage, type Image2D } from '@ubii/proto';
import { pictureFileProblem } from '../../../formats/picture-bitmap.ts';
import { formatNumber } from '../../../ui/readouts/format-number.ts';

const CHANNELS: Readonly<Record<number, number>> = {
  [Image2DDataFormat.GRAY8]: 1,
  [Image2DDataFormat.RGB8]: 3,
  [Image2DDataFormat.RGBA8]: 4,
};
const FILES: Readonly<Record<number, string>> = { 0xff: 'JPEG', 0x89: 'PNG', 0x52: 'WebP' };

/** JPEG, PNG or WebP for an encoded picture, the pixel format for raw bytes. */
export function encodingOf({ data, dataFormat }: Image2D): string {
  if (isCompressedImage(data)) return FILES[data[0]!] ?? 'file';
  const name = Object.entries(Image2DDataFormat).find(([, number]) => number === dataFormat)?.[0];
  return name ?? `layout ${dataFormat}`;
}

/** Returns why a file, or raw bytes of the declared size, are not decoded; undefined if it can be tried [EX-98]. */
export function pictureProblem(image: Image2D): string | undefined {
  const { width, height, dataFormat, data } = image;
  if (data.length === 0) return 'This record has no picture: its data is empty.';
  if (isCompressedImage(data)) return pictureFileProblem(data);
  const channels = CHANNELS[dataFormat];
  if (channels === undefined) {
    return `The pixel layout ${dataFormat} is not GRAY8, RGB8 or RGBA8, and the data is not a JPEG, PNG or WebP file.`;
  }
  if (width <= 0 || height <= 0) {
    return `The record says ${width} × ${height} pixels, and the data is not a JPEG, PNG or WebP file.`;
  }
  const needed = width * height * channels;
  if (data.length >= needed) return sizeProblem(width, height);
  return (
    `The data is too short for the size of the picture: ${width} × ${height} ${encodingOf(image)} needs ` +
    `${formatNumber(needed)} bytes, and the record has ${formatNumber(data.length)}.${guess(image)}`
  );
}

/** Suggests a size that the bytes would match. */
function guess({ width, height, data }: Image2D): string {
  const fits = Object.entries(CHANNELS).find(
    ([, channels]) => width * height * channels === data.length,
  );
  if (!fits) return '';
  const name = Object.entries(Image2DDataFormat).find(([, number]) => String(number) === fits[0]);
  return ` The data matches the format ${name?.[0] ?? fits[0]}.`;
}

/** Returns an anomaly of a picture that can be drawn. */
export function pictureNote(
  image: Image2D,
  drawn: { readonly width: number; readonly height: number },
): string | undefined {
  const { width, height, data, dataFormat } = image;
  if (isCompressedImage(data)) {
    if (width === 0 && height === 0) return undefined;
    if (width === drawn.width && height === drawn.height) return undefined;
    return `The record says ${width} × ${height}, but its ${encodingOf(image)} is ${drawn.width} × ${drawn.height}.`;
  }
  const left = data.length - width * height * (CHANNELS[dataFormat] ?? 0);
  if (left <= 0) return undefined;
  return `The data has ${formatNumber(left)} bytes more than ${width} × ${height} ${encodingOf(image)} needs. They are ignored.`;
}
