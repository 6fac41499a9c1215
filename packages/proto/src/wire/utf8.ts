/**
 * Checks that bytes are well-formed UTF-8 (Unicode 15, table 3-7): no overlong forms, no surrogates,
 * nothing above U+10FFFF.
 *
 * @returns true when all are ASCII
 * @throws RangeError that says where they are not well-formed
 */
export function checkUtf8(bytes: Uint8Array, start: number, end: number): boolean {
  let pos = start;
  while (pos < end && bytes[pos]! < 0x80) pos++;
  if (pos === end) return true;
  while (pos < end) {
    const first = bytes[pos]!;
    if (first < 0x80) {
      pos++;
      continue;
    }
    const length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
    if (
      first < 0xc2 ||
      first > 0xf4 ||
      pos + length > end ||
      !isSecondByte(first, bytes[pos + 1]!)
    ) {
      throw new RangeError(`text is not UTF-8 at byte ${pos}`);
    }
    for (let i = 2; i < length; i++) {
      if ((bytes[pos + i]! & 0xc0) !== 0x80) {
        throw new RangeError(`text is not UTF-8 at byte ${pos}`);
      }
    }
    pos += length;
  }
  return false;
}

/** The second byte is narrower after E0, ED, F0 and F4. */
function isSecondByte(first: number, second: number): boolean {
  const low = first === 0xe0 ? 0xa0 : first === 0xf0 ? 0x90 : 0x80;
  const high = first === 0xed ? 0x9f : first === 0xf4 ? 0x8f : 0xbf;
  return second >= low && second <= high;
}

const decoder = new TextDecoder('utf-8', { ignoreBOM: true });

/**
 * Checks and reads a text.
 *
 * @throws RangeError when the bytes are not well-formed UTF-8
 */
export function readUtf8(bytes: Uint8Array, start: number, end: number): string {
  const isAscii = checkUtf8(bytes, start, end);
  // Up to this length a call into the platform's decoder costs more than it saves.
  if (!isAscii || end - start > 64) return decoder.decode(bytes.subarray(start, end));
  let text = '';
  for (let pos = start; pos < end; pos++) text += String.fromCharCode(bytes[pos]!);
  return text;
}
