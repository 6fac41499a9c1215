import { damaged, unsupported, type PictureHead } from './picture-head.ts';

interface Size {
  readonly width: number;
  readonly height: number;
}

/** "RIFF", length, "WEBP"; and type and length of a chunk. RFC 9649, 2.3 and 2.4. */
const FILE_BYTES = 12;
const CHUNK_BYTES = 8;
/** Bit of VP8X that announces an animation. RFC 9649, 2.7. */
const ANIMATION = 0b10;

/**
 * Reads the size of a WebP file, from its start to the end that its RIFF header states.
 *
 * The first chunk is the picture (VP8 or VP8L) or VP8X; there is one picture, as large as the canvas of VP8X. Animated
 * files are refused. Source: RFC 9649; RFC 6386, 9.1 (VP8).
 *
 * @throws RangeError for damaged and animated files
 */
export function readWebpHead(file: Uint8Array): PictureHead {
  const view = new DataView(file.buffer, file.byteOffset, file.byteLength);
  if (file.length < FILE_BYTES) throw damaged('WebP');
  const fileEnd = CHUNK_BYTES + view.getUint32(4, true);
  if (fileEnd > file.length) throw damaged('WebP');
  let canvas: Size | undefined;
  let picture: Size | undefined;
  for (let at = FILE_BYTES; at < fileEnd;) {
    const data = at + CHUNK_BYTES;
    if (data > fileEnd) throw damaged('WebP');
    const type = String.fromCharCode(...file.subarray(at, at + 4));
    const length = view.getUint32(at + 4, true);
    if (length > fileEnd - data) throw damaged('WebP');
    const isFirst = at === FILE_BYTES;
    if (type === 'VP8X') {
      if (!isFirst) throw damaged('WebP');
      canvas = readCanvas(view, data, length);
    } else if (type === 'VP8 ' || type === 'VP8L') {
      if (picture) throw unsupported('WebP', 'has several pictures', 'Send one');
      picture = type === 'VP8 ' ? readLossy(view, data, length) : readLossless(view, data, length);
    } else if (isFirst) {
      throw damaged('WebP');
    } else if (type === 'ANIM' || type === 'ANMF') {
      throw unsupported('WebP', 'is animated', 'Send a still picture');
    }
    at = data + length + (length & 1);
  }
  if (!picture) throw damaged('WebP');
  const size = canvas ?? picture;
  if (size.width !== picture.width || size.height !== picture.height) throw damaged('WebP');
  return { ...picture, orientation: 1, sizeBytes: Math.min(fileEnd, file.length) };
}

/** Flags, and width and height less 1 of 24 bits each. RFC 9649, 2.7. */
function readCanvas(view: DataView, at: number, length: number): Size {
  if (length !== 10) throw damaged('WebP');
  if ((view.getUint8(at) & ANIMATION) !== 0)
    throw unsupported('WebP', 'is animated', 'Send a still picture');
  const side = (from: number): number =>
    (view.getUint16(from, true) | (view.getUint8(from + 2) << 16)) + 1;
  return { width: side(at + 4), height: side(at + 7) };
}

/** A key frame that is shown: 3 bytes of flags, the start code, and width and height of 14 bits. RFC 6386, 9.1. */
function readLossy(view: DataView, at: number, length: number): Size {
  if (length < 10) throw damaged('WebP');
  const flags = view.getUint8(at);
  const isKeyFrame = (flags & 1) === 0;
  const isShown = (flags & 0x10) !== 0;
  const hasStart = view.getUint16(at + 3) === 0x9d01 && view.getUint8(at + 5) === 0x2a;
  if (!isKeyFrame || !isShown || !hasStart) throw damaged('WebP');
  const side = (from: number): number => view.getUint16(from, true) & 0x3fff;
  return { width: side(at + 6), height: side(at + 8) };
}

/** The signature, width and height less 1 of 14 bits each, opacity, and the version 0 of 3 bits. RFC 9649, 3.4. */
function readLossless(view: DataView, at: number, length: number): Size {
  if (length < 5 || view.getUint8(at) !== 0x2f) throw damaged('WebP');
  const bits = view.getUint32(at + 1, true);
  if (bits >>> 29 !== 0) throw damaged('WebP');
  return { width: (bits & 0x3fff) + 1, height: ((bits >>> 14) & 0x3fff) + 1 };
}
