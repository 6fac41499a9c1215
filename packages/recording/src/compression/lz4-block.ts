/**
 * Blocks of LZ4: https://github.com/lz4/lz4/blob/dev/doc/lz4_Block_format.md. Sequences of a token, literals, and a copy
 * of earlier bytes.
 */
const MIN_MATCH = 4;
/** No match begins in the last 12 bytes, and the last 5 are literals: rules of the format. */
const MATCH_LIMIT = 12;
const LAST_LITERALS = 5;
const MAX_DISTANCE = 65_535;
const HASH_BITS = 14;
/** After 64 positions without a match, every second is tried, and so on: incompressible data passes quickly. */
const SKIP_SHIFT = 6;

/** Bytes that a block of `length` bytes takes at most. */
export function maxBlockBytes(length: number): number {
  return length + Math.floor(length / 255) + 16;
}

/** Compresses blocks; keeps its table of positions from one to the next. */
export class Lz4BlockCompressor {
  readonly #positions = new Int32Array(1 << HASH_BITS);

  /**
   * Compresses bytes.
   *
   * @param target has `maxBlockBytes` at `start`
   * @returns the end of the block in `target`
   */
  compress(source: Uint8Array, target: Uint8Array, start: number): number {
    const view = new DataView(source.buffer, source.byteOffset, source.byteLength);
    const positions = this.#positions.fill(-1);
    const matchLimit = source.length - MATCH_LIMIT;
    let out = start;
    let anchor = 0;
    let misses = 1 << SKIP_SHIFT;
    for (let pos = 0; pos < matchLimit;) {
      const word = view.getInt32(pos, true);
      const slot = Math.imul(word, 0x9e3779b1) >>> (32 - HASH_BITS);
      const candidate = positions[slot]!;
      positions[slot] = pos;
      if (
        candidate < 0 ||
        pos - candidate > MAX_DISTANCE ||
        view.getInt32(candidate, true) !== word
      ) {
        pos += misses++ >>> SKIP_SHIFT;
        continue;
      }
      misses = 1 << SKIP_SHIFT;
      const length = matchLength(view, candidate, pos);
      out = writeSequence(source, anchor, pos, target, out, pos - candidate, length);
      pos += length;
      anchor = pos;
    }
    return writeSequence(source, anchor, source.length, target, out, 0, 0);
  }
}

function matchLength(view: DataView, candidate: number, pos: number): number {
  const end = view.byteLength - LAST_LITERALS;
  let length = MIN_MATCH;
  while (
    pos + length + 4 <= end &&
    view.getInt32(candidate + length, true) === view.getInt32(pos + length, true)
  ) {
    length += 4;
  }
  while (pos + length < end && view.getInt8(candidate + length) === view.getInt8(pos + length)) {
    length++;
  }
  return length;
}

/** Writes literals and a match; a `distance` of 0 writes the last sequence, which has none. */
function writeSequence(
  source: Uint8Array,
  anchor: number,
  pos: number,
  target: Uint8Array,
  start: number,
  distance: number,
  length: number,
): number {
  const literals = pos - anchor;
  const extra = length - MIN_MATCH;
  let out = start + 1;
  target[start] = (Math.min(literals, 15) << 4) | (distance === 0 ? 0 : Math.min(extra, 15));
  if (literals >= 15) out = writeLength(target, out, literals - 15);
  if (literals < 32) for (let i = anchor; i < pos; i++) target[out++] = source[i]!;
  else {
    target.set(source.subarray(anchor, pos), out);
    out += literals;
  }
  if (distance === 0) return out;
  target[out++] = distance & 0xff;
  target[out++] = distance >>> 8;
  return extra >= 15 ? writeLength(target, out, extra - 15) : out;
}

function writeLength(target: Uint8Array, start: number, length: number): number {
  let out = start;
  let rest = length;
  for (; rest >= 255; rest -= 255) target[out++] = 255;
  target[out++] = rest;
  return out;
}

/**
 * Decompresses a block; it may refer to bytes of `target` before `start`.
 *
 * @returns the end of the bytes in `target`
 * @throws RangeError when the block is broken or `target` too small
 */
export function decompressBlock(source: Uint8Array, target: Uint8Array, start: number): number {
  let out = start;
  let pos = 0;
  const readLength = (nibble: number): number => {
    let length = nibble;
    if (nibble < 15) return length;
    for (let byte = 255; byte === 255; length += byte) byte = source[pos++] ?? 0;
    return length;
  };
  while (pos < source.length) {
    const token = source[pos++]!;
    const literals = readLength(token >>> 4);
    if (pos + literals > source.length || out + literals > target.length) throw broken();
    if (literals < 32) for (let i = 0; i < literals; i++) target[out++] = source[pos++]!;
    else {
      target.set(source.subarray(pos, pos + literals), out);
      out += literals;
      pos += literals;
    }
    if (pos >= source.length) return out;
    const distance = source[pos]! | ((source[pos + 1] ?? 0) << 8);
    pos += 2;
    const length = readLength(token & 15) + MIN_MATCH;
    if (distance === 0 || distance > out || out + length > target.length) throw broken();
    out = copyMatch(target, out, distance, length);
  }
  return out;
}

function copyMatch(target: Uint8Array, start: number, distance: number, length: number): number {
  if (length >= 32 && distance >= length) {
    target.copyWithin(start, start - distance, start - distance + length);
    return start + length;
  }
  let out = start;
  for (const end = start + length; out < end; out++) target[out] = target[out - distance]!;
  return out;
}

function broken(): RangeError {
  return new RangeError('The LZ4 block is broken or larger than stated.');
}
