import { describe, expect, it } from 'vitest';
import { affordableRate, MAX_BYTES_PER_SECOND, packPixels, sizeWithin } from './encode-picture.ts';

describe('pictures of a camera', () => {
  it('are made smaller in their shape, never larger', () => {
    expect(sizeWithin({ width: 1280, height: 720 }, 320)).toEqual({ width: 320, height: 180 });
    expect(sizeWithin({ width: 160, height: 120 }, 320)).toEqual({ width: 160, height: 120 });
  });

  it('keep within the bound on bytes by their rate', () => {
    expect(affordableRate(30, 320 * 240 * 3)).toBe(30);
    const bytes = 640 * 480 * 4;
    expect(affordableRate(30, bytes) * bytes).toBeCloseTo(MAX_BYTES_PER_SECOND);
    expect(affordableRate(10, 0)).toBe(10);
  });

  it('have one, three or four bytes a pixel', () => {
    const rgba = Uint8ClampedArray.of(255, 0, 0, 255, 255, 255, 255, 255);
    expect([...packPixels(rgba, 'RGB8')]).toEqual([255, 0, 0, 255, 255, 255]);
    expect([...packPixels(rgba, 'GRAY8')]).toEqual([76, 255]);
    expect([...packPixels(rgba, 'RGBA8')]).toEqual([...rgba]);
  });
});
