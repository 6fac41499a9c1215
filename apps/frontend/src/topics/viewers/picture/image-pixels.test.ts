import { jpegFile } from '@ubii/pictures/testing';
import { Image2DDataFormat } from '@ubii/proto';
import { afterEach, describe, expect, it, vi } from 'vitest';
import { rgbaPixels, toDrawable } from './image-pixels.ts';

const pixelsOf = (dataFormat: Image2DDataFormat, bytes: readonly number[], width = 2, height = 1) =>
  rgbaPixels({ width, height, dataFormat, data: Uint8Array.from(bytes) });

describe('rgbaPixels', () => {
  it('spreads grey over three channels', () => {
    expect([...pixelsOf(Image2DDataFormat.GRAY8, [7, 9])!]).toEqual([7, 7, 7, 255, 9, 9, 9, 255]);
  });

  it('adds opacity to colours', () => {
    expect([...pixelsOf(Image2DDataFormat.RGB8, [1, 2, 3, 4, 5, 6])!]).toEqual([
      1, 2, 3, 255, 4, 5, 6, 255,
    ]);
  });

  it('takes colours with opacity as they are', () => {
    const bytes = [1, 2, 3, 4, 5, 6, 7, 8];
    expect([...pixelsOf(Image2DDataFormat.RGBA8, bytes)!]).toEqual(bytes);
  });

  it('ignores bytes too many and refuses bytes too few', () => {
    expect(pixelsOf(Image2DDataFormat.GRAY8, [1, 2, 3])).toHaveLength(8);
    expect(pixelsOf(Image2DDataFormat.RGB8, [1, 2, 3])).toBeUndefined();
    expect(pixelsOf(Image2DDataFormat.RGB8, [], 0, 0)).toBeUndefined();
  });

  it('refuses sides longer than a canvas has, and negative ones [EX-98]', () => {
    const data = Array.from({ length: 16_385 }, () => 0);
    expect(pixelsOf(Image2DDataFormat.GRAY8, data, 16_385, 1)).toBeUndefined();
    expect(pixelsOf(Image2DDataFormat.GRAY8, data, -2, -2)).toBeUndefined();
  });
});

describe('toDrawable', () => {
  afterEach(() => void vi.unstubAllGlobals());

  it('does not decode a small file of many pixels [EX-98]', async () => {
    const decode = vi.fn();
    vi.stubGlobal('createImageBitmap', decode);
    const data = jpegFile(20_000, 20_000, { scanBytes: 9 });
    const image = { width: 640, height: 480, dataFormat: Image2DDataFormat.RGB8, data };
    await expect(toDrawable(image)).rejects.toThrow('20000 × 20000 pixels is too large.');
    expect(decode).not.toHaveBeenCalled();
  });
});
