import { Image2DDataFormat, type Image2D } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { shrunk } from './thumbnail.ts';

const gray = (width: number, height: number): Image2D => ({
  width,
  height,
  dataFormat: Image2DDataFormat.GRAY8,
  data: Uint8Array.from({ length: width * height }, (_, index) => index),
});

describe('a thumbnail', () => {
  it('takes every nth pixel', () => {
    expect(shrunk(gray(4, 4), 2)).toMatchObject({
      width: 2,
      height: 2,
      data: Uint8Array.of(0, 2, 8, 10),
    });
  });

  it('leaves small and damaged pictures as they are', () => {
    const small = gray(2, 2);
    expect(shrunk(small, 2)).toBe(small);
    const short = { ...gray(8, 8), data: Uint8Array.of(1, 2, 3) };
    expect(shrunk(short, 2)).toBe(short);
  });
});
