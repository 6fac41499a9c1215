import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { MalformedError } from './malformed-error.ts';
import { checkUtf8, readUtf8 } from './utf8.ts';

const strict = new TextDecoder('utf-8', { fatal: true, ignoreBOM: true });

function isAccepted(read: () => unknown): boolean {
  try {
    read();
    return true;
  } catch {
    return false;
  }
}

/** Bytes near the borders of the table, alone and after ASCII of any length. */
const bytes = fc
  .tuple(
    fc.nat(20),
    fc.array(
      fc.constantFrom(
        0x00,
        0x41,
        0x7f,
        0x80,
        0x8f,
        0x90,
        0x9f,
        0xa0,
        0xbf,
        0xc0,
        0xc1,
        0xc2,
        0xdf,
        0xe0,
        0xe1,
        0xec,
        0xed,
        0xee,
        0xef,
        0xf0,
        0xf1,
        0xf3,
        0xf4,
        0xf5,
        0xff,
      ),
      { maxLength: 12 },
    ),
  )
  .map(([ascii, rest]) => Uint8Array.from([...Array.from({ length: ascii }, () => 0x61), ...rest]));

describe('checkUtf8 and readUtf8', () => {
  it('accept what the platform decodes, and nothing else', () => {
    fc.assert(
      fc.property(bytes, (text) => {
        const expected = isAccepted(() => strict.decode(text));
        expect(isAccepted(() => checkUtf8(text, 0, text.length))).toBe(expected);
        expect(isAccepted(() => readUtf8(text, 0, text.length))).toBe(expected);
      }),
      { numRuns: 2000 },
    );
  });

  it.each(['', 'a', 'x'.repeat(12), 'x'.repeat(13), 'ä€😀', `${'x'.repeat(100)}ä`, '\0\uffff'])(
    'read the text %j back, a byte order mark included',
    (text) => {
      for (const whole of [text, `\ufeff${text}`]) {
        const encoded = new TextEncoder().encode(whole);
        expect(readUtf8(encoded, 0, encoded.length)).toBe(whole);
      }
    },
  );

  it('do not look beyond the end', () => {
    expect(() => checkUtf8(Uint8Array.of(0xc3, 0xa4), 0, 1)).toThrow(MalformedError);
    expect(() => checkUtf8(Uint8Array.of(0x61, 0xff), 0, 1)).not.toThrow();
  });
});
