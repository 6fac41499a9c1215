import { expect, it } from 'vitest';
import { decompressLz4 } from '../compression/lz4-frame.ts';
import { lz4Bomb, manyMarkers, metadataIndexOf3Gib, recordChunkIndexOf3Gib } from './index.ts';
import { repeatedLz4 } from './repeated-lz4.ts';

it('hostile files are small', () => {
  expect(metadataIndexOf3Gib()).toHaveLength(129);
  expect(recordChunkIndexOf3Gib().length).toBeLessThan(1000);
  expect(manyMarkers().length).toBeLessThan(2_100_000);
  expect(lz4Bomb().length).toBeLessThan(4_400_000);
});

it.each([1, 2, 3, 100, 500_000])('an LZ4 frame repeats bytes %d times', (count) => {
  const pattern = Uint8Array.of(1, 2, 3, 4, 5, 6, 7, 8, 9, 10);
  const bytes = decompressLz4(repeatedLz4(pattern, count), 10 * count);
  expect(bytes.every((byte, i) => byte === (i % 10) + 1)).toBe(true);
});
