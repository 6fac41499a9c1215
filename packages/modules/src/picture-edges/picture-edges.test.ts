import type { Image2D } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { WAYS } from '../../test/ways.ts';
import { pictureEdges } from './picture-edges.ts';

/** Black at the left, white at the right. */
const STEP = [0, 0, 255, 255, 0, 0, 255, 255, 0, 0, 255, 255];
const grey = (pixels: readonly number[], width = 4, height = 3) => ({
  width,
  height,
  dataFormat: 0,
  data: Uint8Array.from(pixels),
});

describe.each(WAYS)('picture-edges %s', (_way, drive) => {
  it('finds the edge between two areas, and leaves the frame 0', async () => {
    const module = await drive(pictureEdges);
    const outputs = await module.run(0, { picture: grey(STEP) });
    expect([...(outputs.grey as Image2D).data]).toEqual(STEP);
    expect([...(outputs.edges as Image2D).data]).toEqual([0, 0, 0, 0, 0, 255, 255, 0, 0, 0, 0, 0]);
  });

  it('keeps only what reaches the threshold', async () => {
    const module = await drive(pictureEdges);
    const slope = [0, 10, 20, 0, 10, 20, 0, 10, 20];
    const edge = async (threshold: number) =>
      ((await module.run(0, { picture: grey(slope, 3, 3), threshold })).edges as Image2D).data[4];
    expect(await edge(0)).toBe(80);
    expect(await edge(0.2)).toBe(255);
    expect(await edge(0.5)).toBe(0);
  });

  it('weighs colours as the eye does', async () => {
    const module = await drive(pictureEdges);
    const picture = {
      width: 3,
      height: 1,
      dataFormat: 1,
      data: Uint8Array.of(255, 0, 0, 0, 255, 0, 0, 0, 255),
    };
    const outputs = await module.run(0, { picture });
    expect([...(outputs.grey as Image2D).data]).toEqual([76, 150, 29]);
  });

  it('says once what is wrong with a picture, and when that is over', async () => {
    const module = await drive(pictureEdges);
    const wrong = { ...grey(STEP), width: 5 };
    expect(await module.run(0, { picture: wrong })).toEqual({
      error: 'The image has 12 bytes instead of 15. Send raw pixels: GRAY8, RGB8 or RGBA8.',
    });
    expect(await module.run(0)).toEqual({});
    expect(await module.run(0, { picture: grey(STEP) })).toMatchObject({ error: '' });
  });
});
