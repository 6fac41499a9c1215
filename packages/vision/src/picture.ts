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

/** Formats of compressed pictures. */
export type PictureFileFormat = 'JPEG' | 'PNG' | 'WebP';

/** Bytes of a pixel. */
export const CHANNELS: Readonly<Record<PixelFormat, number>> = { GRAY8: 1, RGB8: 3, RGBA8: 4 };

/**
 * Most pixels of a picture: 4096 × 4096, above the 12 megapixels (4032 × 3024) of most phones. With 4
 * channels it has 64 MiB, of which functions make a copy.
 */
export const MAX_PIXELS = 4096 * 4096;

/** Longest side in pixels: a panorama of 16 megapixels with an aspect ratio of 16 : 1. */
export const MAX_SIDE = 16_384;

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
  const compression = compressionOf(picture.data);
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

/** @throws RangeError when the size is invalid or too large */
export function checkSize(width: number, height: number): void {
  const isSide = (side: number): boolean => Number.isInteger(side) && side > 0;
  if (!isSide(width) || !isSide(height)) {
    throw new RangeError(
      `A picture cannot have ${width} × ${height} pixels. Width and height are whole numbers above 0.`,
    );
  }
  if (width > MAX_SIDE || height > MAX_SIDE || width * height > MAX_PIXELS) {
    throw new RangeError(
      `A picture of ${width} × ${height} pixels is too large. At most ${MAX_PIXELS / 2 ** 20} megapixels (2^20) and ${MAX_SIDE} pixels a side are possible.`,
    );
  }
}

function bytesOf({ width, height, format }: Picture): number {
  return width * height * CHANNELS[format];
}

/**
 * Returns the format of a compressed picture by its first bytes; undefined for other data.
 *
 * Sources: ITU-T T.81 B.1.1.3 (JPEG), RFC 2083 3.1 (PNG), RFC 9649 2.4 (WebP).
 */
export function compressionOf(data: Picture['data']): PictureFileFormat | undefined {
  const has = (at: number, ...bytes: number[]): boolean =>
    bytes.every((byte, index) => data[at + index] === byte);
  if (has(0, 0xff, 0xd8, 0xff)) return 'JPEG';
  if (has(0, 0x89, 0x50, 0x4e, 0x47)) return 'PNG';
  if (has(0, 0x52, 0x49, 0x46, 0x46) && has(8, 0x57, 0x45, 0x42, 0x50)) return 'WebP';
  return undefined;
}
