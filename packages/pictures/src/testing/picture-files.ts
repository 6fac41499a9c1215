/** Picture files of tests, as attackers and encoders write them. */

const START_OF_IMAGE = [0xff, 0xd8];
const END_OF_IMAGE = [0xff, 0xd9];

const bigEndian16 = (value: number): number[] => [value >> 8, value & 0xff];
const littleEndian = (value: number, bytes: number): number[] =>
  Array.from({ length: bytes }, (_, index) => (value >>> (8 * index)) & 0xff);
const letters = (text: string): number[] => Array.from(text, (letter) => letter.charCodeAt(0));

/** A segment of a JPEG file: marker, length, data. */
export function jpegSegment(marker: number, data: readonly number[] = []): number[] {
  return [0xff, marker, ...bigEndian16(data.length + 2), ...data];
}

/** A frame of one component. @param marker SOF0 (baseline) by default */
export function jpegFrame(width: number, height: number, marker = 0xc0): number[] {
  return jpegSegment(marker, [8, ...bigEndian16(height), ...bigEndian16(width), 1, 1, 0x11, 0]);
}

/** One quantization table of ones, and Huffman tables with one code of 1 bit each: a difference of 0, and end of block. */
const JPEG_TABLES: readonly number[] = [
  ...jpegSegment(0xdb, [0, ...Array.from({ length: 64 }, () => 1)]),
  ...jpegSegment(0xc4, [0x00, 1, ...Array.from({ length: 15 }, () => 0), 0]),
  ...jpegSegment(0xc4, [0x10, 1, ...Array.from({ length: 15 }, () => 0), 0]),
];
const JPEG_SCAN: readonly number[] = jpegSegment(0xda, [1, 1, 0, 0, 63, 0]);

/**
 * A grey JPEG file that decoders accept, of 2 bits for each 8 × 8 pixels.
 *
 * @param options.before segments and other bytes before the frame
 * @param options.frame bytes instead of the frame
 * @param options.after segments and other bytes between frame and scan
 * @param options.scans number of scans
 * @param options.scanBytes of each scan. @default what the size needs
 */
export function jpegFile(
  width: number,
  height: number,
  options: {
    readonly before?: readonly number[];
    readonly frame?: readonly number[];
    readonly after?: readonly number[];
    readonly scans?: number;
    readonly scanBytes?: number;
  } = {},
): Uint8Array<ArrayBuffer> {
  const { before = [], frame = jpegFrame(width, height), after = [], scans = 1 } = options;
  const blocks = Math.ceil(width / 8) * Math.ceil(height / 8);
  const scan = new Uint8Array(options.scanBytes ?? Math.ceil((2 * blocks) / 8));
  const head = [...START_OF_IMAGE, ...before, ...JPEG_TABLES, ...frame, ...after];
  const parts = [head];
  for (let count = 0; count < scans; count++) parts.push([...JPEG_SCAN], Array.from(scan));
  return Uint8Array.from([...parts.flat(), ...END_OF_IMAGE]);
}

/**
 * A JPEG file of 20,000 × 20,000 pixels for decoders, and of 9 × 9 for a reader that takes the two bytes after each marker
 * as its length.
 *
 * @param start `fill`: a fill byte before the first marker; `marker`: the marker TEM, which has no length
 */
export function jpegWithDecoy(start: 'fill' | 'marker'): Uint8Array<ArrayBuffer> {
  const before = start === 'fill' ? [0xff, ...jpegSegment(0xe0)] : [0xff, 0x01];
  const file = jpegFile(20_000, 20_000, { before, scanBytes: 9 });
  const at = 4 + ((file[4]! << 8) | file[5]!);
  const decoy = jpegFrame(9, 9);
  const bytes = new Uint8Array(at + decoy.length);
  bytes.set(file);
  bytes.set(decoy, at);
  return bytes;
}

/** A chunk of a PNG file, with a checksum of 0. */
export function pngChunk(type: string, data: readonly number[] = []): number[] {
  return [0, 0, ...bigEndian16(data.length), ...letters(type), ...data, 0, 0, 0, 0];
}

/** The header of a PNG file, of 8 bits grey. */
export function pngHeader(width: number, height: number): number[] {
  const sides = [width, height].flatMap((side) => littleEndian(side, 4).reverse());
  return pngChunk('IHDR', [...sides, 8, 0, 0, 0, 0]);
}

/** The structure of a PNG file, which readers of heads accept and decoders do not. */
export function pngFile(...chunks: readonly (readonly number[])[]): Uint8Array<ArrayBuffer> {
  return Uint8Array.from([...[0x89, ...letters('PNG\r\n'), 0x1a, 0x0a], ...chunks.flat()]);
}

/** A chunk of a WebP file. */
export function webpChunk(type: string, data: readonly number[] = []): number[] {
  const padding = data.length % 2 === 0 ? [] : [0];
  return [...letters(type), ...littleEndian(data.length, 4), ...data, ...padding];
}

/** The chunk VP8X. @param flags 2 announces an animation */
export function webpCanvas(width: number, height: number, flags = 0): number[] {
  const sides = [...littleEndian(width - 1, 3), ...littleEndian(height - 1, 3)];
  return webpChunk('VP8X', [flags, 0, 0, 0, ...sides]);
}

/** The head of a lossy picture. */
export function webpLossy(width: number, height: number): number[] {
  const sides = [...littleEndian(width, 2), ...littleEndian(height, 2)];
  return webpChunk('VP8 ', [0x10, 0, 0, 0x9d, 0x01, 0x2a, ...sides]);
}

/** The head of a lossless picture. */
export function webpLossless(width: number, height: number): number[] {
  return webpChunk('VP8L', [0x2f, ...littleEndian((width - 1) | ((height - 1) << 14), 4)]);
}

/** The structure of a WebP file, which readers of heads accept and decoders do not. */
export function webpFile(...chunks: readonly (readonly number[])[]): Uint8Array<ArrayBuffer> {
  const content = [...letters('WEBP'), ...chunks.flat()];
  return Uint8Array.from([...letters('RIFF'), ...littleEndian(content.length, 4), ...content]);
}
