import { MAX_CHOSEN_PIXELS } from '@ubii/pictures';
import { jpegFile, pngChunk, pngFile, pngHeader } from '@ubii/pictures/testing';
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { pictureBitmap } from './picture-bitmap.ts';

const decode = vi.fn((_blob: Blob) => Promise.resolve('bitmap'));
beforeEach(() => void vi.stubGlobal('createImageBitmap', decode.mockClear()));
afterEach(() => void vi.unstubAllGlobals());

it('hands the browser the picture and nothing that follows it [EX-98]', async () => {
  const file = jpegFile(40, 30);
  const followed = Uint8Array.from([...file, 1, 2, 3]);
  expect(await pictureBitmap(followed)).toBe('bitmap');
  expect(decode.mock.lastCall?.[0].size).toBe(file.length);
});

it.each([
  ['too many pixels', jpegFile(20_000, 20_000, { scanBytes: 9 }), undefined],
  ['more than the caller takes', jpegFile(9000, 9000, { scanBytes: 9 }), MAX_CHOSEN_PIXELS],
  ['an animation', pngFile(pngHeader(9, 9), pngChunk('acTL')), undefined],
  ['another format', new TextEncoder().encode('GIF89a'), undefined],
])('does not decode a file with %s [EX-98]', async (_what, file, maxPixels) => {
  await expect(pictureBitmap(file, undefined, maxPixels)).rejects.toThrow(RangeError);
  expect(decode).not.toHaveBeenCalled();
});
