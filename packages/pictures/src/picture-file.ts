import { readJpegHead } from './jpeg-head.ts';
import {
  pictureFormatOf,
  checkSize,
  type PictureFileFormat,
  type PictureHead,
} from './picture-head.ts';
import { readPngHead } from './png-head.ts';
import { readWebpHead } from './webp-head.ts';

/** A still picture whose size a decoder may allocate. */
export interface PictureFile extends PictureHead {
  readonly format: PictureFileFormat;
  /** The file without what follows the picture, not copied. Hand decoders this and nothing else. */
  readonly data: Uint8Array;
}

const READERS: Readonly<Record<PictureFileFormat, (file: Uint8Array) => PictureHead>> = {
  JPEG: readJpegHead,
  PNG: readPngHead,
  WebP: readWebpHead,
};

/**
 * Reads the head of a picture file, and its structure to the end, strictly: decoders allocate what a head says, and
 * differ in which head they believe when a file has several. What this reader does not know, it refuses [EX-98].
 *
 * @param maxPixels width × height. @default MAX_PIXELS
 * @throws RangeError that says what is wrong and what to send: for files other than JPEG, PNG and WebP, and for damaged,
 *   ambiguous, animated and too large ones
 */
export function readPictureFile(file: Uint8Array, maxPixels?: number): PictureFile {
  const format = pictureFormatOf(file);
  if (format === undefined) {
    throw new RangeError('The file is not a picture. Send JPEG, PNG or WebP.');
  }
  const head = READERS[format](file);
  checkSize(head.width, head.height, maxPixels);
  return { ...head, format, data: file.subarray(0, head.sizeBytes) };
}
