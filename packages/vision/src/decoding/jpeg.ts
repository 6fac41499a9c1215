import { decode } from 'jpeg-js';
import { checkSize, MAX_PIXELS, type OwnPicture } from '../picture.ts';
import { orient } from './orient.ts';

/** Markers. ITU-T T.81, table B.1. */
const START_OF_SCAN = 0xda;
const APP1 = 0xe1;
/** Start of frame: C0 to CF without the tables DHT (C4), JPG (C8) and DAC (CC). */
const isStartOfFrame = (marker: number): boolean =>
  marker >= 0xc0 && marker <= 0xcf && marker !== 0xc4 && marker !== 0xc8 && marker !== 0xcc;

/** Properties of a JPEG file that its segments before the pixels contain. */
export interface JpegHead {
  readonly width: number;
  readonly height: number;
  /** Exif orientation, 1 (upright) to 8. */
  readonly orientation: number;
}

/**
 * Decodes a JPEG file to RGB8, upright by its Exif orientation.
 *
 * @throws RangeError for damaged and too large files
 */
export function decodeJpeg(file: Uint8Array): OwnPicture {
  const { width, height, orientation } = readJpegHead(file);
  checkSize(width, height);
  try {
    const { data } = decode(file, {
      useTArray: true,
      formatAsRGBA: false,
      tolerantDecoding: false,
      maxResolutionInMP: Math.ceil(MAX_PIXELS / 1e6),
    });
    return orient({ width, height, format: 'RGB8', data }, orientation);
  } catch {
    throw damaged();
  }
}

/**
 * Reads size and orientation of a JPEG file.
 *
 * @throws RangeError for damaged files
 */
export function readJpegHead(file: Uint8Array): JpegHead {
  const view = new DataView(file.buffer, file.byteOffset, file.byteLength);
  let orientation = 1;
  // Segments: marker (2 bytes), length with its own 2 bytes, data. ITU-T T.81, B.1.1.4.
  for (let at = 2; at + 4 <= file.length;) {
    if (file[at] !== 0xff) break;
    const marker = file[at + 1]!;
    if (marker === 0xff) {
      at += 1;
      continue;
    }
    const length = view.getUint16(at + 2);
    const data = at + 4;
    if (marker === START_OF_SCAN || length < 2 || at + 2 + length > file.length) break;
    if (isStartOfFrame(marker) && length >= 7) {
      return { width: view.getUint16(data + 3), height: view.getUint16(data + 1), orientation };
    }
    if (marker === APP1)
      orientation = readOrientation(view, data, data + length - 2) ?? orientation;
    at += 2 + length;
  }
  throw damaged();
}

/** Exif 2.3: "Exif\0\0", a TIFF header, and the entries of the first directory; tag 0x0112. */
function readOrientation(view: DataView, start: number, end: number): number | undefined {
  const tiff = start + 6;
  if (end - tiff < 8 || view.getUint32(start) !== 0x45786966) return undefined;
  const isLittle = view.getUint16(tiff) === 0x4949;
  const directory = tiff + view.getUint32(tiff + 4, isLittle);
  if (directory + 2 > end) return undefined;
  const count = view.getUint16(directory, isLittle);
  for (
    let entry = directory + 2;
    entry + 12 <= end && entry < directory + 2 + count * 12;
    entry += 12
  ) {
    if (view.getUint16(entry, isLittle) !== 0x0112) continue;
    const value = view.getUint16(entry + 8, isLittle);
    return value >= 1 && value <= 8 ? value : undefined;
  }
  return undefined;
}

function damaged(): RangeError {
  return new RangeError('The JPEG file is damaged. Send the complete file.');
}
