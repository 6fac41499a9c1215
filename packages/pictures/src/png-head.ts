import { damaged, unsupported, type PictureHead } from './picture-head.ts';

/** RFC 2083, 3.1. */
const SIGNATURE = [0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a];
/** Length of a chunk without its data: length, type, checksum. RFC 2083, 3.2. */
const CHUNK_BYTES = 12;
const HEADER_BYTES = 13;
/** Bits of a sample by colour type. RFC 2083, 4.1.1. */
const BIT_DEPTHS: Readonly<Record<number, readonly number[]>> = {
  0: [1, 2, 4, 8, 16],
  2: [8, 16],
  3: [1, 2, 4, 8],
  4: [8, 16],
  6: [8, 16],
};

/**
 * Reads the size of a PNG file, from its start to the chunk IEND.
 *
 * IHDR is the first chunk and the only one of its kind. Animated files are refused. Source: RFC 2083.
 *
 * @throws RangeError for damaged and animated files
 */
export function readPngHead(file: Uint8Array): PictureHead {
  const view = new DataView(file.buffer, file.byteOffset, file.byteLength);
  if (SIGNATURE.some((byte, index) => file[index] !== byte)) throw damaged('PNG');
  let header: { readonly width: number; readonly height: number } | undefined;
  let hasPixels = false;
  for (let at = SIGNATURE.length; at + CHUNK_BYTES <= file.length;) {
    const length = view.getUint32(at);
    const type = String.fromCharCode(...file.subarray(at + 4, at + 8));
    if (length > file.length - at - CHUNK_BYTES) break;
    if ((type === 'IHDR') !== (header === undefined)) break;
    header ??= readHeader(view, at + 8, length);
    if (type === 'acTL') throw unsupported('PNG', 'is animated', 'Send a still picture');
    if (type === 'IDAT') hasPixels = true;
    at += CHUNK_BYTES + length;
    if (type !== 'IEND') continue;
    if (!hasPixels) break;
    return { ...header, orientation: 1, sizeBytes: at };
  }
  throw damaged('PNG');
}

function readHeader(
  view: DataView,
  at: number,
  length: number,
): { readonly width: number; readonly height: number } {
  if (length !== HEADER_BYTES) throw damaged('PNG');
  const [depth, color, compression, filter, interlace] = [8, 9, 10, 11, 12].map((offset) =>
    view.getUint8(at + offset),
  );
  if (!BIT_DEPTHS[color!]?.includes(depth!) || compression !== 0 || filter !== 0 || interlace! > 1)
    throw damaged('PNG');
  return { width: view.getUint32(at), height: view.getUint32(at + 4) };
}
