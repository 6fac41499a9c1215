import { checkSize, pictureFormatOf } from '@ubii/pictures';

/**
 * Layouts of a pixel, one byte a channel: brightness; red, green, blue; and opacity (not premultiplied). In the order of
 * the numbers in `Image2D.DataFormat`.
 */
export const PIXEL_FORMATS = ['GRAY8', 'RGB8', 'RGBA8'] as const;

export type PixelFormat = (typeof PIXEL_FORMATS)[number];

/** Raw pixels, row by row from the top left without gaps. */
export interface Picture {
  /** Pixels in a row. */
  readonly width: number;
  /** Rows. */
  readonly height: number;
  readonly format: PixelFormat;
  /** width · height · channels bytes. */
  readonly data: Uint8Array | Uint8ClampedArray;
}

/** A picture with its own copy of the data. */
export interface OwnPicture extends Picture {
  readonly data: Uint8Array;
}

/** The fields of the message `Image2D`. */
export interface Image2DLike {
  readonly width?: number | null;
  readonly height?: number | null;
  /** Number or name of `Image2D.DataFormat`. */
  readonly dataFormat?: number | string | null;
  readonly data?: Uint8Array | null;
}

/** Bytes of a pixel. */
export const CHANNELS: Readonly<Record<PixelFormat, number>> = { GRAY8: 1, RGB8: 3, RGBA8: 4 };

/**
 * Reads the message `Image2D`. The data is not copied.
 *
 * @throws RangeError that says what is wrong and what to send
 */
export function pictureOfImage2D(image: Image2DLike): Picture {
  const { dataFormat } = image;
  const index =
    typeof dataFormat === 'string'
      ? PIXEL_FORMATS.findIndex((format) => format === dataFormat)
      : (dataFormat ?? 0);
  const format = PIXEL_FORMATS[index];
  if (format === undefined) {
    throw new RangeError(
      `The picture has the unknown format ${dataFormat}. Send GRAY8, RGB8 or RGBA8.`,
    );
  }
  const { width, height, data } = image;
  const picture = {
    width: width ?? 0,
    height: height ?? 0,
    format,
    data: data ?? new Uint8Array(),
  };
  const compression = pictureFormatOf(picture.data);
  // Raw pixels may begin like a file; then their number is right.
  if (compression !== undefined && picture.data.length !== bytesOf(picture)) {
    throw new RangeError(`The picture is a ${compression} file. Decode it to raw pixels first.`);
  }
  checkPicture(picture);
  return picture;
}

/**
 * Checks size and data of a picture.
 *
 * @throws RangeError that says what is wrong and what to send
 */
export function checkPicture(picture: Picture): void {
  const { width, height, format, data } = picture;
  checkSize(width, height);
  if (CHANNELS[format] === undefined) {
    throw new RangeError(
      `The picture has the unknown format ${format}. Send GRAY8, RGB8 or RGBA8.`,
    );
  }
  if (data.length !== bytesOf(picture)) {
    throw new RangeError(
      `The picture has ${data.length} bytes instead of ${bytesOf(picture)} (${width} × ${height} pixels, ${format}).`,
    );
  }
}

function bytesOf({ width, height, format }: Picture): number {
  return width * height * CHANNELS[format];
}
