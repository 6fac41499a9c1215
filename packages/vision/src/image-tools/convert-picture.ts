import {
  CHANNELS,
  checkPicture,
  type OwnPicture,
  type Picture,
  type PixelFormat,
} from '../picture.ts';

/**
 * Shares of red, green and blue in brightness, of 65 536: luma of ITU-R BT.601 (0.299, 0.587, 0.114),
 * what JPEG has as its grey. They add up to 65 536, so that white stays 255.
 */
const LUMA = { red: 19_595, green: 38_470, blue: 7_471, bits: 16 } as const;
const HALF = 1 << (LUMA.bits - 1);

const OPAQUE = 255;

/**
 * Returns a picture in another pixel format. Opacity is dropped or set to opaque; grey from colours
 * is luma (ITU-R BT.601).
 *
 * @throws RangeError when the picture is invalid
 */
export function convertPicture(picture: Picture, format: PixelFormat): OwnPicture {
  checkPicture(picture);
  const { width, height } = picture;
  const data = new Uint8Array(width * height * CHANNELS[format]);
  if (format === picture.format) data.set(picture.data);
  else if (format === 'GRAY8') toGrey(picture, data);
  else toColor(picture, data, CHANNELS[format]);
  return { width, height, format, data };
}

/** Returns the brightness of a picture (luma of ITU-R BT.601), as GRAY8. */
export function greyPicture(picture: Picture): OwnPicture {
  return convertPicture(picture, 'GRAY8');
}

function toGrey({ data, format }: Picture, target: Uint8Array): void {
  const step = CHANNELS[format];
  for (let pixel = 0, at = 0; pixel < target.length; pixel++, at += step) {
    target[pixel] =
      (LUMA.red * data[at]! + LUMA.green * data[at + 1]! + LUMA.blue * data[at + 2]! + HALF) >>
      LUMA.bits;
  }
}

function toColor({ data, format }: Picture, target: Uint8Array, targetStep: number): void {
  const step = CHANNELS[format];
  // Of grey, all three colours are the same byte.
  const [green, blue] = format === 'GRAY8' ? [0, 0] : [1, 2];
  for (let from = 0, to = 0; to < target.length; from += step, to += targetStep) {
    target[to] = data[from]!;
    target[to + 1] = data[from + green]!;
    target[to + 2] = data[from + blue]!;
    if (targetStep === 4) target[to + 3] = OPAQUE;
  }
}
