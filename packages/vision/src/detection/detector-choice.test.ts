import * as tf from '@tensorflow/tfjs-core';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { readAssetSet } from '../../scripts/asset-sets.mjs';
import { readPhoto } from '../../test/photos.ts';
import { squares, tinyCocoSsd } from '../../test/tiny-coco-ssd.ts';
import { sharedTensorflow } from '../tensorflow/create-tensorflow.ts';
import { DetectorChoice, type DetectorSources } from './detector-choice.ts';

const RED_SQUARE = squares({ x: 160, y: 120, rgb: [255, 0, 0] });
const MISSING = Object.assign(new Error('There is no such set.'), { code: 'missing' });

// TensorFlow.js advises against how the library of COCO-SSD runs a model without loops, as the tiny one is.
beforeEach(() => {
  vi.spyOn(console, 'warn').mockReturnValue();
});
afterEach(() => vi.restoreAllMocks());

async function setUp(changes: Partial<DetectorSources> = {}) {
  const told: string[] = [];
  const choice = await DetectorChoice.create({
    tensorflow: readAssetSet('tfjs-wasm'),
    centerNet: readAssetSet('centernet-coco'),
    loadCocoSsd: () => Promise.resolve(tinyCocoSsd()),
    onChange: (text) => void told.push(text),
    ...changes,
  });
  const choose = async (detector: string, backend = 'auto') => {
    choice.choose(detector, backend);
    await choice.settled();
    return [choice.detector, choice.backend, choice.problem];
  };
  return { choice, choose, told };
}

describe('a choice of detectors', () => {
  it('starts with CenterNet on the fastest backend', async () => {
    const { choice, told } = await setUp();
    expect([choice.detector, choice.backend, choice.problem]).toEqual(['centernet', 'wasm', '']);
    expect(told).toEqual(['CenterNet uses wasm. wasm is the fastest backend with right results.']);
    expect(await choice.detect(readPhoto('coffee.jpg'))).toMatchObject([{ class: 'cup' }]);
  });

  it('detects with the old one until the new one is loaded, and frees the old one', async () => {
    let arrive!: () => void;
    const { choice, choose } = await setUp({
      loadCocoSsd: () => new Promise((resolve) => (arrive = () => resolve(tinyCocoSsd()))),
    });
    const before = tf.memory().numTensors;
    choice.choose('coco-ssd', 'auto');
    expect(await choice.detect(readPhoto('coffee.jpg'))).toMatchObject([{ class: 'cup' }]);
    arrive();
    await choice.settled();
    expect(await choice.detect(RED_SQUARE)).toMatchObject([{ class: 'person' }]);
    expect(await choose('centernet')).toEqual(['centernet', 'wasm', '']);
    expect(tf.memory().numTensors).toBe(before);
  });

  it('uses the last of several choices in a row', async () => {
    const { choice, choose } = await setUp();
    choice.choose('coco-ssd', 'auto');
    choice.choose('centernet', 'auto');
    expect(await choose('coco-ssd', 'cpu')).toEqual(['coco-ssd', 'cpu', '']);
    expect(await choice.detect(RED_SQUARE)).toMatchObject([{ class: 'person' }]);
  });

  it('moves to another backend, with the same results', async () => {
    const { choice, choose } = await setUp();
    await choose('coco-ssd');
    const onWasm = await choice.detect(RED_SQUARE);
    expect(await choose('coco-ssd', 'cpu')).toEqual(['coco-ssd', 'cpu', '']);
    const [person] = await choice.detect(RED_SQUARE);
    expect(person!.score).toBeCloseTo(onWasm[0]!.score, 4);
  });

  it('says why a backend is not used', async () => {
    const { choose } = await setUp();
    const [, backend, problem] = await choose('centernet', 'webgl');
    expect(backend).toBe('wasm');
    expect(problem).toBe(
      'wasm instead of webgl: WebGL in workers needs OffscreenCanvas, which is missing here.',
    );
    expect(await choose('centernet', 'auto')).toEqual(['centernet', 'wasm', '']);
  });

  it('says how to get a missing detector, looks again later, and uses it when it has arrived', async () => {
    let nowMs = 0;
    const load = vi.fn(() => Promise.reject(MISSING) as Promise<never>);
    const { choice, choose } = await setUp({ loadCocoSsd: load, now: () => nowMs });
    const [detector, , problem] = await choose('coco-ssd');
    expect(detector).toBe('centernet');
    expect(problem).toBe(
      'The model of COCO-SSD is not installed. Download it on the page of this module, or with "npm run models -- get coco-ssd" on the computer of the master. Until then, CenterNet detects.',
    );
    await choose('coco-ssd');
    expect(load).toHaveBeenCalledTimes(1);
    nowMs = 5000;
    load.mockResolvedValue(tinyCocoSsd() as never);
    expect(await choose('coco-ssd')).toEqual(['coco-ssd', 'wasm', '']);
    expect(await choice.detect(RED_SQUARE)).toMatchObject([{ class: 'person' }]);
  });

  it('names damaged files, and does not load them again and again', async () => {
    const files = tinyCocoSsd();
    const cut = { ...files, 'group1-shard1of1': files['group1-shard1of1']!.slice(1) };
    const load = vi.fn(() => Promise.resolve(cut));
    let nowMs = 0;
    const { choose } = await setUp({ loadCocoSsd: load, now: () => nowMs });
    const [detector, backend, problem] = await choose('coco-ssd', 'cpu');
    // The backend is used anyway.
    expect([detector, backend]).toEqual(['centernet', 'cpu']);
    expect(problem).toMatch(
      /^COCO-SSD cannot be used: The weights of "model.json" have \d+ bytes instead of \d+. Download the model again. CenterNet detects instead.$/,
    );
    nowMs = 3_600_000;
    await choose('coco-ssd', 'cpu');
    expect(load).toHaveBeenCalledTimes(1);
  });

  it('names what there is for unknown names, and leaves the detector in use', async () => {
    const { choose } = await setUp();
    await choose('coco-ssd');
    expect(await choose('yolo', 'cuda')).toEqual([
      'coco-ssd',
      'wasm',
      'There is no detector "yolo". There are centernet and coco-ssd. COCO-SSD detects. There is no backend "cuda". There are auto, webgpu, webgl, wasm, cpu.',
    ]);
  });

  it('continues with another backend when one fails while it detects', async () => {
    let isBroken = false;
    const { choice, choose } = await setUp({
      createTensorflow: async (files, backend) => {
        const real = await sharedTensorflow(files, backend);
        return {
          ...real,
          run: (task) =>
            isBroken && real.backend === 'wasm'
              ? Promise.reject(new Error('The device is lost.'))
              : real.run(task),
        };
      },
    });
    isBroken = true;
    const options = { inputSize: 128 };
    expect(await choice.detect(readPhoto('camera.jpg'), options)).toMatchObject([
      { class: 'person' },
    ]);
    expect([choice.backend, choice.problem]).toEqual([
      'cpu',
      'The backend wasm failed: The device is lost. cpu is used instead.',
    ]);
    expect(choice.backendFault).toBe(
      'wasm failed during use: The device is lost. cpu replaces it.',
    );
    // The same choice does not go back to what failed.
    expect((await choose('centernet', 'auto'))[1]).toBe('cpu');
  });

  it('measures the fastest backend after the first result, and tells which one has wrong numbers', async () => {
    const asked: string[] = [];
    const { choice } = await setUp({
      createTensorflow: async (files, backend) => {
        asked.push(backend);
        const real = await sharedTensorflow(files, 'wasm');
        if (backend === 'soonest') return { ...real, isProvisional: true };
        const reason = 'Its numbers differ from the reference by 25.0 %.';
        return { ...real, trials: [{ name: 'webgl', outcome: 'wrong', reason }, ...real.trials] };
      },
    });
    expect(asked).toEqual(['soonest']);
    await choice.detect(RED_SQUARE);
    await choice.settled();
    await choice.detect(RED_SQUARE);
    await choice.settled();
    expect(asked).toEqual(['soonest', 'auto']);
    expect(choice.backendFault).toBe(
      'webgl does not work: Its numbers differ from the reference by 25.0 %. wasm replaces it.',
    );
  });

  it('leaves what is wrong with a picture or a class to the caller', async () => {
    const { choice } = await setUp();
    await expect(choice.detect(RED_SQUARE, { classes: ['unicorn'] })).rejects.toThrow(RangeError);
    expect(choice.backend).toBe('wasm');
  });

  it('frees what arrives after its end', async () => {
    const { choice } = await setUp();
    const before = tf.memory().numTensors;
    choice.choose('coco-ssd', 'auto');
    choice.dispose();
    await choice.settled();
    expect(tf.memory().numTensors).toBeLessThan(before);
  });
});
