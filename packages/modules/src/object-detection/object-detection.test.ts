import type { Object2DList } from '@ubii/proto';
import { convertPicture, photoFile, PHOTOS, readPhoto, scalePicture } from '@ubii/vision/testing';
import { pngOf } from '@ubii/vision/testing/png';
import { beforeAll, describe, expect, it } from 'vitest';
import { Sample, type DrivenModule } from '../../test/drive-module.ts';
import { driveWithVision, photoImage } from '../../test/vision-assets.ts';
import { objectDetection } from './object-detection.ts';

/** Least overlap of a found box and one measured by hand; see the tests of `@ubii/vision`. */
const MIN_OVERLAP = 0.7;

let module: DrivenModule;
beforeAll(async () => {
  module = await driveWithVision(objectDetection);
}, 60_000);

/** One image, later than the rate asks for. */
const detect = async (image: unknown, parameters: object = {}) =>
  (await module.run(1000, { image, ...parameters }, ['image'])) as {
    predictions?: Object2DList;
    belowThreshold?: Object2DList;
    error?: string;
    backend?: string;
    decodeMs?: number;
    durationMs?: number;
  };
const classesOf = ({ predictions }: { predictions?: Object2DList }) =>
  predictions?.elements.map(({ id }) => id);

describe('object-detection on photographs', () => {
  it.each(PHOTOS)('finds what a person sees in $file', async ({ file, objects }) => {
    const found = await detect(photoImage(file));
    expect(classesOf(found)).toEqual(objects.map((one) => one.class));
    for (const [index, { box }] of objects.entries()) {
      const { pose, size, userDataJson } = found.predictions!.elements[index]!;
      const { x = 0, y = 0 } = pose?.position ?? {};
      const { x: width = 0, y: height = 0 } = size ?? {};
      const inner =
        Math.max(0, Math.min(x + width, box.x + box.width) - Math.max(x, box.x)) *
        Math.max(0, Math.min(y + height, box.y + box.height) - Math.max(y, box.y));
      const outer = width * height + box.width * box.height - inner;
      expect(inner / outer).toBeGreaterThanOrEqual(MIN_OVERLAP);
      expect((JSON.parse(userDataJson) as { score: number }).score).toBeGreaterThan(0.4);
    }
    expect(found.backend).toBe('wasm');
    expect(found.decodeMs).toBeGreaterThanOrEqual(0);
    expect(found.durationMs).toBeGreaterThan(found.decodeMs!);
  });

  it('takes a JPEG file as data, and keeps to classes', async () => {
    const image = { width: 0, height: 0, dataFormat: 0, data: photoFile('coffee.jpg') };
    expect(classesOf(await detect(image))).toEqual(['cup']);
    const cats = { classes: { elements: ['cat'] } };
    expect(classesOf(await detect(image, cats))).toEqual([]);
    await module.run(0, { classes: undefined }, ['classes']);
  });
});

describe('object-detection on images of every format', () => {
  const asFile = (data: Uint8Array) => ({ width: 0, height: 0, dataFormat: 0, data });
  it.each(['GRAY8', 'RGB8', 'RGBA8'] as const)('%s', async (format) => {
    const { width, height, data } = convertPicture(readPhoto('camera.jpg'), format);
    const dataFormat = ['GRAY8', 'RGB8', 'RGBA8'].indexOf(format);
    expect(classesOf(await detect({ width, height, dataFormat, data }))).toEqual(['person']);
  });

  it('JPEG and PNG', async () => {
    expect(classesOf(await detect(asFile(photoFile('coffee.jpg'))))).toEqual(['cup']);
    expect(classesOf(await detect(asFile(pngOf(readPhoto('coffee.jpg')))))).toEqual(['cup']);
  });

  it('of 12 megapixels', async () => {
    const { width, height, data } = scalePicture(readPhoto('chelsea.jpg'), 4032, 3024);
    expect(classesOf(await detect({ width, height, dataFormat: 1, data }))).toEqual(['cat']);
  });

  it.each([
    ['JPEG', () => photoFile('coffee.jpg').slice(0, 2000)],
    ['PNG', () => pngOf(readPhoto('coffee.jpg')).slice(0, 2000)],
    ['no picture', () => Uint8Array.from({ length: 2000 }, (_, index) => index)],
  ])('corrupt %s is an error, and the next image is looked at', async (_name, file) => {
    const { error, predictions } = await detect(asFile(file()));
    expect(error).not.toBe('');
    expect(error).toBeDefined();
    expect(predictions).toBeUndefined();
    expect(await detect(photoImage('coffee.jpg'))).toMatchObject({ error: '' });
  });
});

describe('object-detection', () => {
  it('distinguishes what is above and below the threshold, and leaves out noise', async () => {
    const scores = (list: Object2DList | undefined): number[] =>
      list!.elements.map(
        ({ userDataJson }) => (JSON.parse(userDataJson) as { score: number }).score,
      );
    const low = await detect(photoImage('coffee.jpg'), { threshold: 0.1 });
    const high = await detect(photoImage('coffee.jpg'), { threshold: 0.95 });
    await module.run(0, { threshold: 0.4 }, ['threshold']);
    expect(scores(low.belowThreshold)).toEqual([]);
    expect(scores(high.predictions)).toEqual([]);
    expect(scores(high.belowThreshold)).toEqual(scores(low.predictions));
    expect(scores(high.belowThreshold).length).toBeGreaterThan(1);
    expect(Math.min(...scores(high.belowThreshold))).toBeGreaterThanOrEqual(0.1);
  });

  it('gives its results the time at which the image was taken', async () => {
    const timestamp = { seconds: 1_800_000_000, nanos: 250_000_000 };
    const image = new Sample(photoImage('coffee.jpg'), { timestamp });
    await detect(image);
    expect(module.outputs['predictions']).toMatchObject({ timestamp });
    expect(module.outputs['durationMs']).not.toHaveProperty('timestamp');
  });

  it('says once what is wrong with an image, and continues with the next', async () => {
    const broken = { width: 10, height: 10, dataFormat: 2, data: new Uint8Array(7) };
    const { error } = await detect(broken);
    expect(error).toMatch(/7 bytes/);
    expect(await detect(broken)).toEqual({});
    expect(await detect(photoImage('coffee.jpg'))).toMatchObject({ error: '', backend: 'wasm' });
  });

  it('names a class that it does not know', async () => {
    const { error } = await detect(photoImage('coffee.jpg'), {
      classes: { elements: ['unicorn'] },
    });
    expect(error).toContain('unicorn');
    await module.run(0, { classes: undefined }, ['classes']);
    await detect(photoImage('coffee.jpg'));
  });

  it('drops images beyond its rate, and does not run again for a parameter', async () => {
    await detect(photoImage('coffee.jpg'), { maxRate: 2 });
    expect(await module.run(100, {}, ['image'])).toEqual({});
    expect(await module.run(1000, { threshold: 0.9 }, ['threshold'])).toEqual({});
    expect(classesOf(await detect(photoImage('coffee.jpg'), { threshold: 0.4 }))).toEqual(['cup']);
  });
});
