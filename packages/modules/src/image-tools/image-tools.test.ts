import type { DoubleList, Image2D } from '@ubii/proto';
import { photoFile } from '@ubii/vision/testing';
import { beforeEach, describe, expect, it } from 'vitest';
import type { DrivenModule } from '../../test/drive-module.ts';
import { driveWithVision } from '../../test/vision-assets.ts';
import { imageTools } from './image-tools.ts';

let module: DrivenModule;
beforeEach(async () => {
  module = await driveWithVision(imageTools);
}, 60_000);

const run = async (image: unknown, parameters: object = {}) =>
  (await module.run(0, { image, ...parameters }, ['image'])) as {
    image?: Image2D;
    motion?: number;
    changed?: number;
    histogram?: DoubleList;
    decodeMs?: number;
    durationMs?: number;
    error?: string;
  };
/** Left half black, right half of this brightness. */
const halves = (right: number) => ({
  width: 4,
  height: 2,
  dataFormat: 0,
  data: Uint8Array.of(0, 0, right, right, 0, 0, right, right),
});

describe('image-tools', () => {
  it('puts out an image as it is without parameters, with its histogram', async () => {
    const { image, histogram } = await run(halves(255), { bins: 2 });
    expect(image).toEqual(halves(255));
    expect(histogram?.elements).toEqual([0.5, 0.5]);
  });

  it('says which value of a parameter is used in place of one that is out of its range', async () => {
    const { histogram, error } = await run(halves(255), { bins: 999 });
    expect(histogram?.elements).toHaveLength(256);
    expect(error).toBe('bins is 1 to 256, not 999; 256 is used.');
    expect((await run(halves(255), { bins: 999 })).error).toBeUndefined();
    expect((await run(halves(255), { bins: 8 })).error).toBe('');
  });

  it('crops, scales and converts, in this order', async () => {
    const { image } = await run(halves(200), { x: 0.5, width: 0.5, maxSide: 1, format: 'RGB8' });
    expect(image).toEqual({
      width: 1,
      height: 1,
      dataFormat: 1,
      data: Uint8Array.of(200, 200, 200),
    });
  });

  it('reads a JPEG file', async () => {
    const file = { width: 0, height: 0, dataFormat: 0, data: photoFile('coffee.jpg') };
    const { image, decodeMs, durationMs } = await run(file, { maxSide: 64, format: 'GRAY8' });
    expect(image).toMatchObject({ width: 64, dataFormat: 0 });
    expect(new Set(image!.data).size).toBeGreaterThan(20);
    expect(decodeMs).toBeGreaterThan(0);
    expect(durationMs).toBeGreaterThan(decodeMs!);
  });

  it('measures motion from the second image on', async () => {
    expect((await run(halves(0))).motion).toBeUndefined();
    expect(await run(halves(255))).toMatchObject({ motion: 0.5, changed: 0.5 });
    expect(await run(halves(255))).toMatchObject({ motion: 0, changed: 0 });
    const larger = { width: 1, height: 1, dataFormat: 0, data: Uint8Array.of(1) };
    expect((await run(larger)).motion).toBeUndefined();
  });

  it('says once what is wrong with an image or a parameter', async () => {
    const broken = { width: 10, height: 10, dataFormat: 2, data: new Uint8Array(7) };
    expect((await run(broken)).error).toMatch(/7 bytes/);
    expect(await run(broken)).toEqual({});
    expect((await run(halves(1), { format: 'CMYK' })).error).toContain('not "CMYK"');
    expect((await run(halves(1), { format: '', x: 1 })).error).toContain('outside of the picture');
    expect((await run(halves(1), { x: 5 })).error).toMatch(
      /x is 0 to below 1, not 1\..*x is 0 to 1, not 5/,
    );
    expect((await run(halves(1), { x: 0 })).error).toBe('');
  });

  it('does not run for a parameter alone', async () => {
    await run(halves(1));
    expect(await module.run(0, { bins: 4 }, ['bins'])).toEqual({});
  });
});
