import fc from 'fast-check';
import { expect, it } from 'vitest';
import { decompress } from '../mcap/unpack-chunk.ts';
import { decompressLz4, Lz4Compressor } from './lz4-frame.ts';

const runs = fc
  .array(fc.tuple(fc.uint8Array({ maxLength: 40 }), fc.integer({ min: 1, max: 60 })))
  .map((parts) =>
    parts.flatMap(([bytes, times]) => Array.from({ length: times }, () => [...bytes])),
  )
  .map((parts) => Uint8Array.from(parts.flat()));

it('gives back what was compressed, random or repetitive', () => {
  const compressor = new Lz4Compressor();
  fc.assert(
    fc.property(fc.oneof(runs, fc.uint8Array({ maxLength: 5_000 })), (bytes) => {
      expect(decompressLz4(compressor.compress(bytes), bytes.length)).toEqual(bytes);
    }),
  );
});

it('makes repetitive bytes small', () => {
  expect(new Lz4Compressor().compress(new Uint8Array(100_000)).length).toBeLessThan(1_000);
});

it('splits what is larger than a block', () => {
  const bytes = Uint8Array.from({ length: 9_000_000 }, (_, i) => (i * i) >>> 7);
  const back = decompressLz4(new Lz4Compressor().compress(bytes), bytes.length);
  expect(Buffer.compare(back, bytes)).toBe(0);
});

it('refuses broken frames', () => {
  const frame = new Lz4Compressor().compress(Uint8Array.from({ length: 3_000 }, (_, i) => i % 97));
  fc.assert(
    fc.property(fc.nat(frame.length - 1), fc.integer({ min: 1, max: 255 }), (at, change) => {
      const broken = frame.slice();
      broken[at]! ^= change;
      try {
        expect(decompressLz4(broken, 3_000)).toHaveLength(3_000);
      } catch (error) {
        expect(error).toBeInstanceOf(RangeError);
      }
    }),
  );
  expect(() => decompressLz4(frame.slice(0, -5), 3_000)).toThrow(RangeError);
});

it('reads frames of other programs and refuses other compressions', async () => {
  // PyPI `lz4`: linked blocks, a checksum of the content, no size; PyPI `zstandard`.
  const lz4 = Buffer.from('BCJNGGRApw8AAABPdWJpIAQA/3VQIHViaSAAAAAAIOlR5g==', 'base64');
  const zstd = Buffer.from('KLUv/SAXZQAAMGhlbGxvIAEAmUsR', 'base64');
  const text = (bytes: Uint8Array): string => new TextDecoder().decode(bytes);
  expect(text(await decompress('lz4', lz4, 400))).toBe('ubi '.repeat(100));
  expect(text(await decompress('zstd', zstd, 23))).toBe('hello hello hello hello');
  await expect(decompress('brotli', zstd, 23)).rejects.toThrow('"brotli"');
});
