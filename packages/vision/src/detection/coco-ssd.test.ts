import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import * as tf from '@tensorflow/tfjs-core';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { readAssetSet } from '../../scripts/asset-sets.mjs';
import { CELLS, squares, tinyCocoSsd } from '../../test/tiny-coco-ssd.ts';
import { createTensorflow } from '../tensorflow/create-tensorflow.ts';
import { COCO_CLASSES } from './coco-classes.ts';
import { createCocoSsd } from './coco-ssd.ts';

const RED = [255, 0, 0];
const GREEN = [0, 255, 0];
const BLUE = [0, 0, 255];

// TensorFlow.js advises against how the library runs a model without loops, as the tiny one is.
beforeEach(() => {
  vi.spyOn(console, 'warn').mockReturnValue();
});
afterEach(() => vi.restoreAllMocks());

async function detector() {
  return createCocoSsd(await createTensorflow(readAssetSet('tfjs-wasm')), tinyCocoSsd());
}

describe('createCocoSsd', () => {
  it('finds what the model scores, with class, score and box', async () => {
    const { detect } = await detector();
    const found = await detect(squares({ x: 160, y: 120, rgb: RED }, { x: 40, y: 30, rgb: GREEN }));
    expect(found.map((one) => one.class).sort()).toEqual(['person', 'stop sign']);
    const { box, score } = found.find((one) => one.class === 'person')!;
    expect(score).toBeGreaterThan(0.99);
    // The square is cell 8 of column and row; its box reaches 2 cells around its middle.
    expect(box.x * CELLS).toBeCloseTo(6.5);
    expect(box.y * CELLS).toBeCloseTo(6.5);
    expect(box.width * CELLS).toBeCloseTo(4);
    expect(box.height * CELLS).toBeCloseTo(4);
  });

  it('cuts boxes at the border of the picture', async () => {
    const { detect } = await detector();
    const [corner] = await detect(squares({ x: 0, y: 0, rgb: BLUE }), { maxObjects: 1 });
    expect(corner).toMatchObject({ class: 'toothbrush', box: { x: 0, y: 0 } });
    expect(corner!.box.width).toBeLessThan(4 / CELLS);
  });

  it('keeps to classes, threshold and number', async () => {
    const { detect } = await detector();
    const three = squares(
      { x: 0, y: 0, rgb: RED },
      { x: 200, y: 30, rgb: GREEN },
      { x: 80, y: 180, rgb: RED },
    );
    const classesOf = async (options: object) =>
      (await detect(three, options)).map((one) => one.class);
    expect((await classesOf({})).sort()).toEqual(['person', 'person', 'stop sign']);
    expect(await classesOf({ classes: ['stop sign'] })).toEqual(['stop sign']);
    expect(await classesOf({ classes: ['dog'] })).toEqual([]);
    expect(await classesOf({ maxObjects: 1 })).toHaveLength(1);
    expect(await classesOf({ threshold: 1 })).toEqual([]);
  });

  it('finds the same in each pixel format', async () => {
    const { detect } = await detector();
    const { width, height, data } = squares({ x: 160, y: 120, rgb: RED });
    const rgba = new Uint8ClampedArray(width * height * 4).fill(255);
    for (let pixel = 0; pixel < width * height; pixel++) {
      rgba.set(data.subarray(pixel * 3, pixel * 3 + 3), pixel * 4);
    }
    const fromRgb = await detect({ width, height, format: 'RGB8', data });
    expect(await detect({ width, height, format: 'RGBA8', data: rgba })).toEqual(fromRgb);
    const grey = new Uint8Array(width * height).fill(200);
    expect(await detect({ width, height, format: 'GRAY8', data: grey })).toEqual([]);
  });

  it('frees what an inference takes, and the model', async () => {
    const before = tf.memory().numTensors;
    const { detect, dispose } = await detector();
    const loaded = tf.memory().numTensors;
    await detect(squares({ x: 160, y: 120, rgb: RED }));
    expect(tf.memory().numTensors).toBe(loaded);
    dispose();
    expect(tf.memory().numTensors).toBe(before);
  });

  it('refuses corrupt pictures and unknown classes', async () => {
    const { detect } = await detector();
    const picture = squares();
    await expect(detect({ ...picture, width: 321 })).rejects.toThrow(
      'The picture has 230400 bytes instead of 231120 (321 × 240 pixels, RGB8).',
    );
    await expect(detect(picture, { classes: ['unicorn'] })).rejects.toThrow(
      'The detector does not know the class "unicorn". It knows: person, bicycle,',
    );
  });

  it('names damaged files', async () => {
    const tensorflow = await createTensorflow(readAssetSet('tfjs-wasm'));
    const files = tinyCocoSsd();
    await expect(createCocoSsd(tensorflow, {})).rejects.toThrow('The file "model.json"');
    const cut = { ...files, 'group1-shard1of1': files['group1-shard1of1']!.slice(1) };
    await expect(createCocoSsd(tensorflow, cut)).rejects.toThrow(
      /^The weights of "model.json" have \d+ bytes instead of \d+. Download the model again.$/,
    );
  });
});

it('the library has our classes in our order', () => {
  const { resolve } = createRequire(import.meta.url);
  const path = join(dirname(resolve('@tensorflow-models/coco-ssd')), 'classes.js');
  const { CLASSES } = createRequire(import.meta.url)(path) as {
    CLASSES: Record<string, { displayName: string }>;
  };
  expect(Object.values(CLASSES).map(({ displayName }) => displayName)).toEqual(COCO_CLASSES);
});
