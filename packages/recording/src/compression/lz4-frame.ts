import { decompressBlock, Lz4BlockCompressor, maxBlockBytes } from './lz4-block.ts';

const PRIME_1 = 0x9e3779b1;
const PRIME_2 = 0x85ebca77;
const PRIME_3 = 0xc2b2ae3d;
const PRIME_4 = 0x27d4eb2f;
const PRIME_5 = 0x165667b1;

const rotate = (value: number, bits: number): number => (value << bits) | (value >>> (32 - bits));

/**
 * The checksum XXH32 of less than 16 bytes, with seed 0: what the header of an LZ4 frame needs.
 * https://github.com/Cyan4973/xxHash/blob/dev/doc/xxhash_spec.md
 */
function xxh32OfShort(bytes: Uint8Array): number {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let hash = (PRIME_5 + bytes.length) | 0;
  let pos = 0;
  for (; pos + 4 <= bytes.length; pos += 4) {
    hash = (hash + Math.imul(view.getUint32(pos, true), PRIME_3)) | 0;
    hash = Math.imul(rotate(hash, 17), PRIME_4);
  }
  for (; pos < bytes.length; pos++) {
    hash = (hash + Math.imul(view.getUint8(pos), PRIME_5)) | 0;
    hash = Math.imul(rotate(hash, 11), PRIME_1);
  }
  hash = Math.imul(hash ^ (hash >>> 15), PRIME_2);
  hash = Math.imul(hash ^ (hash >>> 13), PRIME_3);
  return (hash ^ (hash >>> 16)) >>> 0;
}

/** Frames of LZ4, which MCAP calls `lz4`: https://github.com/lz4/lz4/blob/dev/doc/lz4_Frame_format.md */
const MAGIC = 0x184d2204;
/** Version 1, independent blocks, size of the content stated, no checksums: MCAP has its own. */
const FLAGS = 0b0110_1000;
/** Blocks of up to 4 MiB. */
const BLOCK_SIZE_CODE = 0b0111_0000;
const BLOCK_BYTES = 4 * 1024 * 1024;
const IS_UNCOMPRESSED = 0x8000_0000;
const HEADER_BYTES = 15;

/** Compresses bytes to frames; keeps buffers from one to the next. */
export class Lz4Compressor {
  readonly #blocks = new Lz4BlockCompressor();
  #target = new Uint8Array();

  /** Returns a frame, valid until the next call. */
  compress(source: Uint8Array): Uint8Array {
    const blocks = Math.ceil(source.length / BLOCK_BYTES);
    const maxBytes = HEADER_BYTES + maxBlockBytes(source.length) + blocks * 20 + 4;
    if (this.#target.length < maxBytes) this.#target = new Uint8Array(maxBytes);
    const target = this.#target;
    const view = new DataView(target.buffer);
    writeHeader(target, view, source.length);
    let out = HEADER_BYTES;
    for (let start = 0; start < source.length; start += BLOCK_BYTES) {
      const block = source.subarray(start, start + BLOCK_BYTES);
      const end = this.#blocks.compress(block, target, out + 4);
      const bytes = end - out - 4;
      if (bytes < block.length) {
        view.setUint32(out, bytes, true);
        out = end;
      } else {
        view.setUint32(out, block.length + IS_UNCOMPRESSED, true);
        target.set(block, out + 4);
        out += 4 + block.length;
      }
    }
    view.setUint32(out, 0, true);
    return target.subarray(0, out + 4);
  }
}

function writeHeader(target: Uint8Array, view: DataView, contentBytes: number): void {
  view.setUint32(0, MAGIC, true);
  target[4] = FLAGS;
  target[5] = BLOCK_SIZE_CODE;
  view.setBigUint64(6, BigInt(contentBytes), true);
  target[14] = (xxh32OfShort(target.subarray(4, 14)) >>> 8) & 0xff;
}

/**
 * Decompresses a frame. Checksums are not looked at.
 *
 * @param bytes of the content
 * @throws RangeError when the frame is broken or has another size
 */
export function decompressLz4(frame: Uint8Array, bytes: number): Uint8Array {
  const view = new DataView(frame.buffer, frame.byteOffset, frame.byteLength);
  if (view.getUint32(0, true) !== MAGIC) throw new RangeError('This is no LZ4 frame.');
  const flags = view.getUint8(4);
  const hasDictionary = (flags & 1) !== 0;
  const hasContentSize = (flags & 0b1000) !== 0;
  const blockChecksumBytes = (flags & 0b1_0000) !== 0 ? 4 : 0;
  if (hasDictionary) throw new RangeError('LZ4 frames with a dictionary cannot be read.');
  const target = new Uint8Array(bytes);
  let out = 0;
  let pos = 7 + (hasContentSize ? 8 : 0);
  for (;;) {
    const size = view.getUint32(pos, true);
    if (size === 0) break;
    pos += 4;
    const end = pos + (size & ~IS_UNCOMPRESSED);
    const block = frame.subarray(pos, end);
    if (size >= IS_UNCOMPRESSED) {
      target.set(block, out);
      out += block.length;
    } else out = decompressBlock(block, target, out);
    pos = end + blockChecksumBytes;
  }
  if (out !== bytes) throw new RangeError(`The LZ4 frame has ${out} bytes, ${bytes} are stated.`);
  return target;
}
