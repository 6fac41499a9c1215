import { jpegFile } from '@ubii/pictures/testing';
import { Image2DDataFormat, type Image2D } from '@ubii/proto';
import { afterEach, describe, expect, it, vi } from 'vitest';
import { shrunk, thumbnail } from './thumbnail.ts';

const gray = (width: number, height: number): Image2D => ({
  width,
  height,
  dataFormat: Image2DDataFormat.GRAY8,
  data: Uint8Array.from({ length: width * height }, (_, index) => index),
});

describe('a thumbnail', () => {
  afterEach(() => void vi.unstubAllGlobals());

  it('is not decoded of a file of many pixels, nor made of raw pixels of such a size [EX-98]', async () => {
    const decode = vi.fn();
    vi.stubGlobal('createImageBitmap', decode);
    const file = { ...gray(1, 1), data: jpegFile(20_000, 20_000, { scanBytes: 9 }) };
    await expect(thumbnail(file)).rejects.toThrow('is too large');
    expect(await thumbnail(gray(20_000, 1))).toBeUndefined();
    expect(decode).not.toHaveBeenCalled();
  });

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
