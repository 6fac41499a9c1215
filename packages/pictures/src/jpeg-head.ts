import { damaged, unsupported, type PictureHead } from './picture-head.ts';

/**
 * Returns the orientation, 1 to 8, of an APP1 segment of a JPEG file; undefined without one.
 *
 * Source: Exif 2.3: "Exif\0\0", a TIFF header, and the entries of the first directory; tag 0x0112.
 */
function readExifOrientation(view: DataView, start: number, end: number): number | undefined {
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

/** Markers. ITU-T T.81, table B.1. */
const RESTART_FIRST = 0xd0;
const RESTART_LAST = 0xd7;
const END_OF_IMAGE = 0xd9;
const START_OF_SCAN = 0xda;
const NUMBER_OF_LINES = 0xdc;
const APP1 = 0xe1;
/** Baseline, extended sequential and progressive with Huffman coding, which browsers decode. */
const FRAMES: ReadonlySet<number> = new Set([0xc0, 0xc1, 0xc2]);
/** Lossless, hierarchical and arithmetic frames with their tables, and DNL, which changes the height later. */
const UNSUPPORTED: ReadonlySet<number> = new Set([
  ...[0xc3, 0xc5, 0xc6, 0xc7, 0xc8, 0xc9, 0xca, 0xcb, 0xcc, 0xcd, 0xce, 0xcf],
  ...[NUMBER_OF_LINES, 0xde, 0xdf],
]);
/** DHT, DQT, DRI and COM; APP0 to APP15 are these too. */
const PASSED_OVER: ReadonlySet<number> = new Set([0xc4, 0xdb, 0xdd, 0xfe]);
const isApplication = (marker: number): boolean => marker >= 0xe0 && marker <= 0xef;

/**
 * Most scans of a file. Encoders write about 10 for a progressive picture; a scan of few bytes makes decoders pass over
 * all pixels.
 */
const MAX_SCANS = 100;

const SAVE_AGAIN = 'Save it again as a baseline JPEG file';

/** Bytes of a marker, and of the length that follows it. */
const MARKER_BYTES = 2;
const LENGTH_BYTES = 2;

/**
 * Reads size and orientation of a JPEG file, from its start to the end of the picture.
 *
 * Before and between scans, segments follow one another, each a marker with a length; fill bytes (0xFF) may precede a marker.
 * Anything else is refused: markers without a length (TEM, RST0 to RST7, a second SOI), a second frame, DNL.
 * Source: ITU-T T.81, B.1.1 and B.2.
 *
 * @throws RangeError for damaged files and those that decoders may read differently
 */
export function readJpegHead(file: Uint8Array): PictureHead {
  const view = new DataView(file.buffer, file.byteOffset, file.byteLength);
  let frame: { readonly width: number; readonly height: number } | undefined;
  let orientation = 1;
  let scans = 0;
  for (let at = MARKER_BYTES; at < file.length;) {
    at = passFillBytes(file, at);
    const marker = file[at + 1];
    if (marker === END_OF_IMAGE && frame && scans > 0) {
      return { ...frame, orientation, sizeBytes: at + MARKER_BYTES };
    }
    const data = at + MARKER_BYTES + LENGTH_BYTES;
    if (marker === undefined || data > file.length) throw damaged('JPEG');
    checkMarker(marker);
    const end = at + MARKER_BYTES + view.getUint16(at + MARKER_BYTES);
    if (end < data || end > file.length) throw damaged('JPEG');
    if (FRAMES.has(marker)) {
      if (frame) throw unsupported('JPEG', 'has several frames', SAVE_AGAIN);
      frame = readFrame(view, data, end);
    } else if (marker === APP1) {
      orientation = readExifOrientation(view, data, end) ?? orientation;
    }
    at = end;
    if (marker === START_OF_SCAN) {
      if (!frame) throw damaged('JPEG');
      if (++scans > MAX_SCANS)
        throw unsupported('JPEG', `has more than ${MAX_SCANS} scans`, SAVE_AGAIN);
      at = endOfScan(file, end);
    }
  }
  // Decoders show the part of a picture whose end is cut off.
  if (frame && scans > 0) return { ...frame, orientation, sizeBytes: file.length };
  throw damaged('JPEG');
}

/** Returns where the 0xFF is that the marker follows. B.1.1.2 */
function passFillBytes(file: Uint8Array, at: number): number {
  if (file[at] !== 0xff) throw damaged('JPEG');
  let last = at;
  while (file[last + 1] === 0xff) last++;
  return last;
}

function checkMarker(marker: number): void {
  if (FRAMES.has(marker) || PASSED_OVER.has(marker) || isApplication(marker)) return;
  if (marker === START_OF_SCAN) return;
  if (!UNSUPPORTED.has(marker)) throw damaged('JPEG');
  const what =
    marker === NUMBER_OF_LINES
      ? 'states its height after its pixels'
      : 'is neither baseline nor progressive';
  throw unsupported('JPEG', what, SAVE_AGAIN);
}

/** Precision, height, width, and of each component identifier, sampling factors and table. B.2.2 */
function readFrame(
  view: DataView,
  at: number,
  end: number,
): { readonly width: number; readonly height: number } {
  if (end - at < 6) throw damaged('JPEG');
  const components = view.getUint8(at + 5);
  if (components < 1 || components > 4 || end - at !== 6 + 3 * components) throw damaged('JPEG');
  if (view.getUint8(at) !== 8)
    throw unsupported('JPEG', 'has more than 8 bits a sample', SAVE_AGAIN);
  for (let component = 0; component < components; component++) {
    const sampling = view.getUint8(at + 7 + 3 * component);
    for (const factor of [sampling >> 4, sampling & 15]) {
      if (factor < 1 || factor > 4) throw damaged('JPEG');
    }
  }
  return { height: view.getUint16(at + 1), width: view.getUint16(at + 3) };
}

/** Returns where the coded data of a scan ends: at a marker that is no restart. B.1.1.5 */
function endOfScan(file: Uint8Array, start: number): number {
  for (let at = start; at < file.length; at++) {
    if (file[at] !== 0xff) continue;
    const next = file[at + 1];
    const isOfScan =
      next === undefined ||
      next === 0 ||
      next === 0xff ||
      (next >= RESTART_FIRST && next <= RESTART_LAST);
    if (!isOfScan) return at;
  }
  return file.length;
}
