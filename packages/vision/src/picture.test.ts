import { describe, expect, it } from 'vitest';
import { pictureOfImage2D } from './picture.ts';

describe('pictureOfImage2D', () => {
  it.each([
    [0, 'GRAY8', 6],
    [1, 'RGB8', 18],
    [2, 'RGBA8', 24],
    ['RGBA8', 'RGBA8', 24],
    [undefined, 'GRAY8', 6],
  ])('reads the format %s', (dataFormat, format, length) => {
    const data = new Uint8Array(length);
    const picture = pictureOfImage2D({ width: 3, height: 2, dataFormat, data });
    expect(picture).toEqual({ width: 3, height: 2, format, data });
    expect(picture.data).toBe(data);
  });

  it.each([
    [{ data: Uint8Array.of(1) }, 'A picture cannot have 0 × 0 pixels.'],
    [{ width: 2, height: -2, data: Uint8Array.of(1) }, 'A picture cannot have 2 × -2 pixels.'],
    [
      { width: 2, height: 2, data: Uint8Array.of(1, 2, 3) },
      'The picture has 3 bytes instead of 4 (2 × 2 pixels, GRAY8).',
    ],
    [{ width: 2, height: 2 }, 'The picture has 0 bytes instead of 4 (2 × 2 pixels, GRAY8).'],
    [{ width: 50_000, height: 50_000 }, 'A picture of 50000 × 50000 pixels is too large.'],
    [
      { width: 1, height: 1, dataFormat: 3, data: Uint8Array.of(1) },
      'The picture has the unknown format 3. Send GRAY8, RGB8 or RGBA8.',
    ],
    [
      { width: 1, height: 1, dataFormat: 'toString', data: Uint8Array.of(1) },
      'The picture has the unknown format toString.',
    ],
    [
      { width: 640, height: 480, data: Uint8Array.of(0xff, 0xd8, 0xff, 0xe0) },
      'The picture is a JPEG file. Decode it to raw pixels first.',
    ],
    [{ data: Uint8Array.of(0x89, 0x50, 0x4e, 0x47) }, 'The picture is a PNG file.'],
    [
      { data: new TextEncoder().encode('RIFF1234WEBP') },
      'The picture is a WebP file. Decode it to raw pixels first.',
    ],
  ])('says what is wrong: %o', (image, message) => {
    expect(() => pictureOfImage2D(image)).toThrow(message);
  });

  it('takes raw pixels that begin like a file', () => {
    const data = Uint8Array.of(0xff, 0xd8, 0xff);
    expect(pictureOfImage2D({ width: 1, height: 1, dataFormat: 1, data }).format).toBe('RGB8');
  });
});
