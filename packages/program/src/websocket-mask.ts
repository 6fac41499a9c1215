import { endianness } from 'node:os';

/*
 * The two functions that `ws` takes from the native package `bufferutil` where it is installed; the builds of the programs give
 * it these instead. Its own functions go byte by byte, which takes as long for a picture as sending it to five subscribers.
 */

/** Shorter payloads are not worth another view of their memory, bytes. */
const MIN_WORDS_BYTES = 128;
const IS_LITTLE_ENDIAN = endianness() === 'LE';

/**
 * Applies the mask of a WebSocket frame (RFC 6455, section 5.3) to its payload, in place; the second time takes it away.
 *
 * @param mask four bytes
 */
export function unmask(payload: Uint8Array, mask: Uint8Array): void {
  const { length } = payload;
  if (length < MIN_WORDS_BYTES || !IS_LITTLE_ENDIAN) {
    applyMask(payload, mask, 0, length);
    return;
  }
  // Words begin at multiples of four.
  const start = -payload.byteOffset & 3;
  const words = new Int32Array(payload.buffer, payload.byteOffset + start, (length - start) >>> 2);
  const byteAt = (i: number): number => mask[(start + i) & 3]!;
  const key = byteAt(0) | (byteAt(1) << 8) | (byteAt(2) << 16) | (byteAt(3) << 24);
  applyMask(payload, mask, 0, start);
  const { length: count } = words;
  let i = 0;
  for (; i + 3 < count; i += 4) {
    words[i]! ^= key;
    words[i + 1]! ^= key;
    words[i + 2]! ^= key;
    words[i + 3]! ^= key;
  }
  for (; i < count; i++) words[i]! ^= key;
  applyMask(payload, mask, start + 4 * count, length);
}

/**
 * Writes the masked payload of a frame.
 *
 * @param output may be `source`
 * @param offset in `output`, bytes
 * @param length of the payload, bytes
 */
export function mask(
  source: Uint8Array,
  mask: Uint8Array,
  output: Uint8Array,
  offset: number,
  length: number,
): void {
  if (source !== output || offset !== 0) output.set(source.subarray(0, length), offset);
  unmask(output.subarray(offset, offset + length), mask);
}

function applyMask(payload: Uint8Array, mask: Uint8Array, start: number, end: number): void {
  for (let i = start; i < end; i++) payload[i]! ^= mask[i & 3]!;
}
