import * as tf from '@tensorflow/tfjs-core';
import { beforeAll, describe, expect, it } from 'vitest';
import { readAssetSet } from '../../scripts/asset-sets.mjs';
import { PHOTOS, readPhoto } from '../../test/photos.ts';
import { convertPicture } from '../image-tools/convert-picture.ts';
import { cropPicture, scalePicture } from '../image-tools/crop-and-scale.ts';
import { createTensorflow, type Tensorflow } from '../tensorflow/create-tensorflow.ts';
import { overlap } from './boxes.ts';
import { createCenterNet } from './center-net.ts';
import type { Detector } from './detector.ts';

/**
 * Least overlap (intersection over union) of a found box and one measured by hand. COCO counts from
 * 0.5 on; borders of fur and of hands at a camera are a matter of taste, which 0.7 leaves room for.
 */
const MIN_OVERLAP = 0.7;

let tensorflow: Tensorflow;
let detector: Detector;
beforeAll(async () => {
  tensorflow = await createTensorflow(readAssetSet('tfjs-wasm'));
  detector = await createCenterNet(tensorflow, readAssetSet('centernet-coco'));
});

describe.each(PHOTOS)('CenterNet on $file', ({ file, objects }) => {
  it('finds the main objects and nothing wrong', async () => {
    const found = await detector.detect(readPhoto(file));
    expect(found.map((one) => one.class)).toEqual(objects.map((one) => one.class));
    for (const [index, { box }] of objects.entries()) {
      expect(overlap(found[index]!.box, box)).toBeGreaterThanOrEqual(MIN_OVERLAP);
    }
  });
});

describe('CenterNet', () => {
  it('takes the size that it was trained with', async () => {
    const [cup, ...others] = await detector.detect(readPhoto('coffee.jpg'), { inputSize: 512 });
    expect(cup!.class).toBe('cup');
    expect(others).toEqual([]);
  });

  it('finds a person at 256 pixels, in each pixel format', async () => {
    const photo = readPhoto('camera.jpg');
    const find = async (format: 'GRAY8' | 'RGB8' | 'RGBA8') =>
      (await detector.detect(convertPicture(photo, format), { inputSize: 256 })).map(
        ({ class: name, box }) => [name, Math.round(box.width * 20) / 20],
      );
    const inColor = await find('RGB8');
    expect(inColor).toEqual([['person', 0.55]]);
    expect(await find('RGBA8')).toEqual(inColor);
    expect(await find('GRAY8')).toEqual(inColor);
  });

  it('gives boxes of the picture whatever its proportions', async () => {
    const photo = readPhoto('camera.jpg');
    // The left two thirds: the man fills them.
    const part = cropPicture(photo, { x: 0, y: 0, width: 340, height: 512 });
    const [man] = await detector.detect(part, { inputSize: 256 });
    expect(man).toMatchObject({ class: 'person' });
    expect(overlap(man!.box, { x: 0, y: 0.12, width: 0.95, height: 0.88 })).toBeGreaterThan(0.7);
  });

  it('finds a cat in 12 megapixels', async () => {
    const large = scalePicture(readPhoto('chelsea.jpg'), 4032, 3024);
    expect(await detector.detect(large, { inputSize: 256 })).toMatchObject([{ class: 'cat' }]);
  });

  it('keeps to classes, threshold and number', async () => {
    const photo = readPhoto('coffee.jpg');
    const find = async (options: object) =>
      (await detector.detect(photo, { inputSize: 256, ...options })).map((one) => one.class);
    expect(await find({ classes: ['cat', 'cup'] })).toEqual(['cup']);
    expect(await find({ classes: ['cat'] })).toEqual([]);
    expect(await find({ threshold: 0.9 })).toEqual([]);
    const many = await find({ threshold: 0.05 });
    expect(many.length).toBeGreaterThan(3);
    expect(await find({ threshold: 0.05, maxObjects: 2 })).toEqual(many.slice(0, 2));
  });

  it('finds nothing in one colour, and accepts the smallest and flattest pictures', async () => {
    const plain = (width: number, height: number) => ({
      width,
      height,
      format: 'GRAY8' as const,
      data: new Uint8Array(width * height).fill(128),
    });
    const options = { inputSize: 128 };
    expect(await detector.detect(plain(64, 64), options)).toEqual([]);
    expect(await detector.detect(plain(1, 1), options)).toEqual([]);
    expect(await detector.detect(plain(5000, 1), options)).toEqual([]);
  });

  it('takes numbers out of range as the nearest in range', async () => {
    const photo = readPhoto('camera.jpg');
    const options = { inputSize: -5, threshold: NaN, maxObjects: 1e9 };
    const usual = await detector.detect(photo, { inputSize: 128 });
    expect(await detector.detect(photo, options)).toEqual(usual);
  });

  it('frees what an inference takes, and the model', async () => {
    const before = tf.memory().numTensors;
    const other = await createCenterNet(tensorflow, readAssetSet('centernet-coco'));
    const loaded = tf.memory().numTensors;
    await other.detect(readPhoto('coffee.jpg'), { inputSize: 128 });
    expect(tf.memory().numTensors).toBe(loaded);
    other.dispose();
    expect(tf.memory().numTensors).toBe(before);
  });

  it('names damaged files', async () => {
    const files = readAssetSet('centernet-coco');
    await expect(createCenterNet(tensorflow, {})).rejects.toThrow(
      'The file "centernet.json" of the model "centernet.json" is missing.',
    );
    const cut = { ...files, 'centernet.bin': files['centernet.bin']!.slice(0, 1000) };
    await expect(createCenterNet(tensorflow, cut)).rejects.toThrow(
      'The weights of "centernet.json" have 1000 bytes instead of 4030290. Download the model again.',
    );
  });
});
