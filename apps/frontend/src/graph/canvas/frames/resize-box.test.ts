import { describe, expect, it } from 'vitest';
import { resizeBox } from './resize-box.ts';

const box = { x: 100, y: 100, width: 300, height: 200 };

describe('resizeBox', () => {
  it('moves the edges of the handle only', () => {
    expect(resizeBox('frame', box, { x: 1, y: 1 }, { x: 40, y: -30 })).toEqual({
      x: 100,
      y: 100,
      width: 340,
      height: 170,
    });
    expect(resizeBox('frame', box, { x: -1, y: 0 }, { x: -50, y: 90 })).toEqual({
      x: 50,
      y: 100,
      width: 350,
      height: 200,
    });
  });

  it('keeps the opposite edge where the box cannot be smaller', () => {
    const { x, width } = resizeBox('frame', box, { x: -1, y: -1 }, { x: 900, y: 900 });
    expect(x + width).toBe(400);
    expect(width).toBe(120);
  });
});
