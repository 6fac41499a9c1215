/**
 * Bytes a number takes as a varint.
 *
 * @param value integer from 0 to 2^32 - 1
 */
export function varintSize(value: number): number {
  if (value < 0x80) return 1;
  if (value < 0x4000) return 2;
  if (value < 0x20_0000) return 3;
  return value < 0x1000_0000 ? 4 : 5;
}

/**
 * Writes a number as a varint.
 *
 * @param value integer from 0 to 2^32 - 1
 * @returns the position after it
 */
export function writeVarint(target: Uint8Array, start: number, value: number): number {
  let pos = start;
  let rest = value;
  while (rest >= 0x80) {
    target[pos++] = (rest & 0x7f) | 0x80;
    rest >>>= 7;
  }
  target[pos++] = rest;
  return pos;
}
