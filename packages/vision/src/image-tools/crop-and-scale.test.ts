import { describe, expect, it } from 'vitest';

import { cropPicture, cutSquare, placeInPicture } from './crop-and-scale.ts';

const [width, height] = [40, 30];
const data = Uint8Array.from(
  { length: width * height },
  (_, index) => (index % width) * 4 + Math.floor(index / width) * 2,
);
const slope = { width, height, format: 'GRAY8' as const, data };

describe('cutSquare', () => {
  it('is a crop when it is not turned', () => {
    const part = cutSquare(slope, { x: 15, y: 14, side: 10, angle: 0 }, 10);
    expect(part).toEqual(cropPicture(slope, { x: 10, y: 9, width: 10, height: 10 }));
  });

  it('turns by quarters without loss', () => {
    const part = cutSquare(slope, { x: 15, y: 14, side: 10, angle: Math.PI / 2 }, 10);
    // Its x axis points down in the picture, its y axis to the left.
    const at = (x: number, y: number) => part.data[y * 10 + x];
    expect(at(0, 0)).toBe(data[9 * width + 19]);
    expect(at(9, 0)).toBe(data[18 * width + 19]);
    expect(at(0, 9)).toBe(data[9 * width + 10]);
  });

  it('has the brightness of the places it shows, at any angle and size', () => {
    const square = { x: 20, y: 15, side: 12, angle: 0.7 };
    const part = cutSquare(slope, square, 24);
    for (let index = 0; index < 24 * 24; index += 5) {
      const { x, y } = placeInPicture(
        square,
        ((index % 24) + 0.5) / 24,
        (Math.floor(index / 24) + 0.5) / 24,
      );
      expect(Math.abs(part.data[index]! - ((x - 0.5) * 4 + (y - 0.5) * 2))).toBeLessThanOrEqual(1);
    }
  });

  it('is 0 outside of the picture', () => {
    const white = { ...slope, data: new Uint8Array(width * height).fill(255) };
    const part = cutSquare(white, { x: 0, y: 0, side: 20, angle: 0 }, 20);
    expect(part.data[0]).toBe(0);
    expect(part.data[15 * 20 + 15]).toBe(255);
    expect(cutSquare(white, { x: NaN, y: 0, side: 20, angle: 0 }, 4).data).toEqual(
      new Uint8Array(16),
    );
  });
});
