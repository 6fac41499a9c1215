import { describe, expect, it } from 'vitest';
import { CHANNELS, type OwnPicture, type PixelFormat } from '../picture.ts';
import { convertPicture, greyPicture } from './convert-picture.ts';
import { cropPicture, scalePicture } from './crop-and-scale.ts';
import { histogram, motionEnergy } from './measure-picture.ts';

/** A scene whose pixels are known by their place. */
function scene(
  width: number,
  height: number,
  format: PixelFormat,
  at: (x: number, y: number, channel: number) => number,
): OwnPicture {
  const step = CHANNELS[format];
  const data = new Uint8Array(width * height * step);
  for (let index = 0; index < data.length; index++) {
    const pixel = Math.floor(index / step);
    data[index] = at(pixel % width, Math.floor(pixel / width), index % step);
  }
  return { width, height, format, data };
}
const empty = (width: number, height: number) => scene(width, height, 'GRAY8', () => 0);

describe('cropPicture', () => {
  const place = scene(8, 6, 'RGB8', (x, y, channel) => x * 10 + y + channel * 100);

  it('returns the part with its pixels', () => {
    const part = cropPicture(place, { x: 2, y: 1, width: 3, height: 2 });
    expect(part).toEqual(scene(3, 2, 'RGB8', (x, y, c) => (x + 2) * 10 + y + 1 + c * 100));
  });

  it('leaves out what is outside, and takes pixels that are touched', () => {
    expect(cropPicture(place, { x: -5, y: 4.2, width: 6.5, height: 90 })).toMatchObject({
      width: 2,
      height: 2,
    });
  });

  it.each([
    { x: 8, y: 0, width: 2, height: 2 },
    { x: 0, y: 0, width: 0, height: 2 },
    { x: 0, y: NaN, width: 1, height: 1 },
    { x: 0, y: 0, width: -1, height: 1 },
  ])('refuses a part without pixels: %o', (rectangle) => {
    expect(() => cropPicture(place, rectangle)).toThrow('is outside of the picture (8 × 6).');
  });
});

describe('scalePicture', () => {
  it('returns the same picture for the same size', () => {
    const picture = scene(7, 5, 'RGBA8', (x, y, channel) => x * 30 + y * 3 + channel);
    expect(scalePicture(picture, 7, 5)).toEqual(picture);
  });

  it.each([
    [20, 20],
    [13, 7],
    [200, 3],
  ])('keeps a slope a slope at %i × %i', (width, height) => {
    const slope = scene(100, 40, 'GRAY8', (x) => x * 2);
    const scaled = scalePicture(slope, width, height);
    // Brightness at the middle of a new pixel, in old pixels; at the ends there is no neighbour, and
    // columns that fill no block are left out.
    for (let x = 0; x < width - 1; x++) {
      const truth = Math.min(198, Math.max(0, (((x + 0.5) * 100) / width - 0.5) * 2));
      expect(Math.abs(scaled.data[x]! - truth)).toBeLessThanOrEqual(1);
    }
  });

  it('turns a fine pattern into its mean', () => {
    const board = scene(64, 64, 'GRAY8', (x, y) => ((x + y) % 2) * 200);
    expect(new Set(scalePicture(board, 16, 16).data)).toEqual(new Set([100]));
  });

  it('keeps a disc where it is', () => {
    const disc = scene(300, 200, 'GRAY8', (x, y) =>
      (x - 199.5) ** 2 + (y - 49.5) ** 2 < 900 ? 255 : 0,
    );
    const { data } = scalePicture(disc, 61, 37);
    let [sum, sumX, sumY] = [0, 0, 0];
    for (const [index, value] of data.entries()) {
      sum += value;
      sumX += value * ((index % 61) + 0.5);
      sumY += value * (Math.floor(index / 61) + 0.5);
    }
    // A tenth of a pixel of the small picture.
    expect(Math.abs(sumX / sum / 61 - 200 / 300) * 61).toBeLessThan(0.1);
    expect(Math.abs(sumY / sum / 37 - 50 / 200) * 37).toBeLessThan(0.1);
  });

  it('scales 12 megapixels', () => {
    const large = scene(4000, 3000, 'RGB8', (x, _y, channel) => (channel === 0 ? x >> 4 : 7));
    const { data } = scalePicture(large, 512, 384);
    expect([data[1], data[2], data.at(-3), data.at(-1)]).toEqual([7, 7, 249, 7]);
  });

  it.each([
    [0, 5, 'A picture cannot have 0 × 5 pixels.'],
    [5.5, 5, 'A picture cannot have 5.5 × 5 pixels.'],
    [NaN, 5, 'A picture cannot have NaN × 5 pixels.'],
    [20_000, 1, 'A picture of 20000 × 1 pixels is too large.'],
    [5000, 5000, 'At most 16 megapixels (2^20) and 16384 pixels a side are possible.'],
  ])('refuses the size %f × %f', (width, height, message) => {
    expect(() => scalePicture(empty(4, 4), width, height)).toThrow(message);
  });
});

describe('convertPicture', () => {
  it('makes grey of colours as ITU-R BT.601 says', () => {
    const colors = scene(5, 1, 'RGB8', (x, _y, channel) => (x === channel || x === 3 ? 255 : 0));
    expect([...greyPicture(colors).data]).toEqual([76, 150, 29, 255, 0]);
  });

  it('copies grey to all colours, and is opaque', () => {
    const grey = scene(2, 1, 'GRAY8', (x) => 5 + x);
    expect([...convertPicture(grey, 'RGB8').data]).toEqual([5, 5, 5, 6, 6, 6]);
    expect([...convertPicture(grey, 'RGBA8').data]).toEqual([5, 5, 5, 255, 6, 6, 6, 255]);
  });

  it('drops opacity', () => {
    const color = scene(2, 1, 'RGBA8', (x, _y, channel) => x * 4 + channel);
    expect([...convertPicture(color, 'RGB8').data]).toEqual([0, 1, 2, 4, 5, 6]);
    expect(greyPicture(scene(1, 1, 'RGBA8', (_x, _y, c) => (c === 3 ? 0 : 90))).data[0]).toBe(90);
  });

  it('returns a copy for the same format', () => {
    const picture = empty(2, 2);
    const copy = convertPicture(picture, 'GRAY8');
    expect(copy).toEqual(picture);
    expect(copy.data.buffer).not.toBe(picture.data.buffer);
  });
});

describe('motionEnergy', () => {
  it('is 0 for the same picture and 1 from black to white', () => {
    const black = empty(9, 9);
    const white = scene(9, 9, 'RGBA8', () => 255);
    expect(motionEnergy(black, black)).toEqual({ energy: 0, changedShare: 0 });
    expect(motionEnergy(black, white)).toEqual({ energy: 1, changedShare: 1 });
  });

  it('counts the pixels a square left and entered', () => {
    const square = (left: number) =>
      scene(100, 100, 'GRAY8', (x, y) => (x >= left && x < left + 20 && y < 20 ? 255 : 0));
    // 5 columns of 20 pixels at each side.
    expect(motionEnergy(square(10), square(15)).changedShare).toBe(0.02);
    expect(motionEnergy(square(10), square(15)).energy).toBeCloseTo(0.02, 10);
  });

  it('takes changes below the threshold for noise', () => {
    const dim = scene(4, 4, 'GRAY8', () => 20);
    expect(motionEnergy(empty(4, 4), dim).changedShare).toBe(0);
    expect(motionEnergy(empty(4, 4), dim, 0.05).changedShare).toBe(1);
    expect(motionEnergy(empty(4, 4), empty(4, 4), 0).changedShare).toBe(0);
  });

  it('refuses pictures of different size', () => {
    expect(() => motionEnergy(empty(4, 4), empty(4, 5))).toThrow(
      'Motion needs two pictures of one size, not 4 × 4 and 4 × 5.',
    );
  });
});

describe('histogram', () => {
  it('counts each channel by itself', () => {
    const picture = scene(4, 2, 'RGB8', (x, _y, channel) => (channel === 0 ? x * 80 : 255));
    const [red, green] = histogram(picture, 4);
    expect([...red!]).toEqual([2, 2, 2, 2]);
    expect([...green!]).toEqual([0, 0, 0, 8]);
  });

  it('has a bin for each value by default, and all pixels in them', () => {
    const slope = scene(256, 3, 'GRAY8', (x) => x);
    expect(histogram(slope)).toEqual([new Uint32Array(256).fill(3)]);
  });

  it.each([0, 257, 1.5, NaN])('refuses %f bins', (bins) => {
    expect(() => histogram(empty(1, 1), bins)).toThrow('A histogram has 1 to 256 bins');
  });
});
