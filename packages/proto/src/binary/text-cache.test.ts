import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { MalformedError } from './malformed-error.ts';
import { TextCache } from './text-cache.ts';

const encoder = new TextEncoder();

describe('TextCache', () => {
  it('reads every text as it is, however often', () => {
    const cache = new TextCache();
    fc.assert(
      fc.property(fc.array(fc.string({ unit: 'binary', maxLength: 300 })), (texts) => {
        for (const text of [...texts, ...texts]) {
          const bytes = encoder.encode(`<${text}>`);
          expect(cache.read(bytes, 1, bytes.length - 1)).toBe(text);
        }
      }),
    );
  });

  it('tells texts apart that share a place', () => {
    const cache = new TextCache();
    const texts = Array.from({ length: 5000 }, (_, i) => `/device ${i}/position`);
    for (const text of [...texts, ...texts]) {
      const bytes = encoder.encode(text);
      expect(cache.read(bytes, 0, bytes.length)).toBe(text);
    }
  });

  it('keeps nothing of the bytes it read', () => {
    const cache = new TextCache();
    const bytes = encoder.encode('/topic');
    cache.read(bytes, 0, bytes.length);
    bytes[1] = 0x54;
    expect(cache.read(bytes, 0, bytes.length)).toBe('/Topic');
    expect(cache.read(encoder.encode('/topic'), 0, bytes.length)).toBe('/topic');
  });

  it('refuses what is not UTF-8, every time [TD-12]', () => {
    const cache = new TextCache();
    const bytes = Uint8Array.of(0x2f, 0xc3, 0x28);
    for (let i = 0; i < 2; i++) expect(() => cache.read(bytes, 0, 3)).toThrow(MalformedError);
  });
});
