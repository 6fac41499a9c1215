import { readUtf8 } from './utf8.ts';

/** Texts remembered at a time; a power of two. A busy room uses some hundred topics. */
const SLOTS = 1024;

/** Longer texts are not remembered, bytes: together they take half a megabyte at most. */
const MAX_LENGTH = 256;

/** An odd number with its bits well mixed: 2^32 divided by the golden ratio. */
const MULTIPLIER = 0x9e37_79b1;

/**
 * Reads texts and remembers them by their bytes. For texts that come again and again, as topics do
 * with every record: comparing costs half of decoding, and a text that was the key of a map before
 * is found faster than a new one.
 */
export class TextCache {
  readonly #bytes = new Array<Uint8Array | undefined>(SLOTS).fill(undefined);
  readonly #texts = new Array<string>(SLOTS).fill('');

  /** @throws MalformedError when the bytes are not well-formed UTF-8 */
  read(bytes: Uint8Array, start: number, end: number): string {
    const length = end - start;
    if (length > MAX_LENGTH) return readUtf8(bytes, start, end);
    const slot = slotOf(bytes, start, end);
    const known = this.#bytes[slot];
    if (known !== undefined && known.length === length) {
      let i = 0;
      while (i < length && known[i] === bytes[start + i]) i++;
      if (i === length) return this.#texts[slot]!;
    }
    const text = readUtf8(bytes, start, end);
    this.#bytes[slot] = new Uint8Array(bytes.subarray(start, end));
    this.#texts[slot] = text;
    return text;
  }
}

/** Every byte counts, since topics often differ in one; four at a time, since this is the hot path. */
function slotOf(bytes: Uint8Array, start: number, end: number): number {
  let hash = end - start;
  let pos = start;
  for (; pos + 4 <= end; pos += 4) {
    const word =
      bytes[pos]! | (bytes[pos + 1]! << 8) | (bytes[pos + 2]! << 16) | (bytes[pos + 3]! << 24);
    hash = Math.imul(hash ^ word, MULTIPLIER) ^ (hash >>> 15);
  }
  for (; pos < end; pos++) hash = Math.imul(hash ^ bytes[pos]!, MULTIPLIER) ^ (hash >>> 15);
  return (hash ^ (hash >>> 15)) & (SLOTS - 1);
}
