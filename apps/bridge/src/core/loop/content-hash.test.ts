import type { DataFormat } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { contentHash } from './content-hash.ts';

const hash = (format: DataFormat, value: unknown): string => contentHash({ format, value });

describe('what stands for a value [BR-23]', () => {
  it.each([
    ['double', 0.1, Math.fround(0.1)],
    ['double', 0, -0],
    ['color', { r: 0.3, g: 0, b: 1, a: 1 }, { r: Math.fround(0.3), g: 0, b: 1, a: 1 }],
    ['floatList', { elements: [0.1, 2] }, { elements: [Math.fround(0.1), 2] }],
    ['image2D', { data: Uint8Array.of(1, 2, 3, 4, 5) }, { data: Buffer.from([1, 2, 3, 4, 5]) }],
  ] as const)('is the same for %s, however often it was rounded', (format, one, other) => {
    expect(hash(format, one)).toBe(hash(format, other));
  });

  it.each([
    ['double', 0.1, 0.2],
    ['double', 1, -1],
    ['int32', 16_777_216, 16_777_217],
    ['vector2', { x: 1, y: 1 }, { x: -1, y: -1 }],
    ['vector2', { x: 1, y: 2 }, { x: 2, y: 1 }],
    ['stringList', { elements: ['a', 'bc'] }, { elements: ['ab', 'c'] }],
    ['bool', true, false],
    ['image2D', { data: Uint8Array.of(1, 2, 3, 4) }, { data: Uint8Array.of(1, 2, 3, 4, 0) }],
  ] as const)('differs for other values of %s', (format, one, other) => {
    expect(hash(format, one)).not.toBe(hash(format, other));
  });

  it('has the same length for a picture as for a number', () => {
    const data = new Uint8Array(4 * 1024 * 1024).fill(7);
    expect(hash('image2D', { data }).length).toBeLessThanOrEqual(17);
  });

  it('is another one for each of many values', () => {
    const hashes = Array.from({ length: 50_000 }, (_, index) => hash('int32', index));
    expect(new Set(hashes).size).toBe(hashes.length);
  });
});
