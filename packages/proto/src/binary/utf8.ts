import { MalformedError } from './malformed-error.ts';

/**
 * Checks that bytes are well-formed UTF-8 (Unicode 15, table 3-7): no overlong forms, no surrogates,
 * nothing above U+10FFFF.
 *
 * @throws MalformedError that says where they are not
 */
export function checkUtf8(bytes: Uint8Array, start: number, end: number): void {
  let pos = start;
  // Nearly all text on this channel is ASCII: eight bytes at a time cost a third of one by one.
  while (
    pos + 8 <= end &&
    (bytes[pos]! |
      bytes[pos + 1]! |
      bytes[pos + 2]! |
      bytes[pos + 3]! |
      bytes[pos + 4]! |
      bytes[pos + 5]! |
      bytes[pos + 6]! |
      bytes[pos + 7]!) <
      0x80
  ) {
    pos += 8;
  }
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
      throw new MalformedError(`text is not UTF-8 at byte ${pos}`);
    }
    for (let i = 2; i < length; i++) {
      if ((bytes[pos + i]! & 0xc0) !== 0x80) {
        throw new MalformedError(`text is not UTF-8 at byte ${pos}`);
      }
    }
    pos += length;
  }
}

/** The second byte is narrower after E0, ED, F0 and F4. */
function isSecondByte(first: number, second: number): boolean {
  const low = first === 0xe0 ? 0xa0 : first === 0xf0 ? 0x90 : 0x80;
  const high = first === 0xed ? 0x9f : first === 0xf4 ? 0x8f : 0xbf;
  return second >= low && second <= high;
}

const decoder = new TextDecoder('utf-8', { fatal: true, ignoreBOM: true });

/** Up to this length, bytes, a call into the platform's decoder costs more than it saves. */
const SHORT_TEXT = 12;

/**
 * Reads a text. Longer text goes through the platform's decoder, which makes a flat string: as a key
 * of a map that costs a third of one put together from characters.
 *
 * @throws MalformedError when the bytes are not well-formed UTF-8
 */
export function readUtf8(bytes: Uint8Array, start: number, end: number): string {
  if (end - start <= SHORT_TEXT) {
    const text = readAscii(bytes, start, end);
    if (text !== undefined) return text;
  }
  try {
    return decoder.decode(bytes.subarray(start, end));
  } catch {
    throw new MalformedError(`text is not UTF-8 between bytes ${start} and ${end}`);
  }
}

function readAscii(bytes: Uint8Array, start: number, end: number): string | undefined {
  let text = '';
  for (let pos = start; pos < end; pos++) {
    const byte = bytes[pos]!;
    if (byte >= 0x80) return undefined;
    text += String.fromCharCode(byte);
  }
  return text;
}
