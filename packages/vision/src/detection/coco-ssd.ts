import { load } from '@tensorflow-models/coco-ssd';
import * as tf from '@tensorflow/tfjs-core';
import { fitModelInput } from '../model-input.ts';
import type { Tensorflow } from '../tensorflow/create-tensorflow.ts';
import type { Files } from '../tensorflow/memory-platform.ts';
import { readModelFiles } from '../tensorflow/model-files.ts';
import { boxBetween } from './boxes.ts';
import { COCO_CLASSES } from './coco-classes.ts';
import { type DetectionDefaults, type Detector, resolveOptions } from './detector.ts';

/** The model's file in its asset set. */
export const COCO_SSD_MODEL = 'model.json';

const DEFAULTS: DetectionDefaults = {
  // The default of the library.
  threshold: 0.5,
  // The model makes 300 × 300 of any picture: with 400, a picture of 4 : 3 has them on both sides.
  inputSize: { least: 128, most: 1024, usual: 400 },
};

/** Asked for when classes are filtered afterwards, and the most a caller gets. */
const MAX_OBJECTS = 100;

/**
 * Loads a model of `@tensorflow-models/coco-ssd`, by the code of that library, out of memory.
 *
 * @param files the model's asset set: `model.json` and the weights it names
 * @throws Error that names the file that is missing or damaged
 */
export async function createCocoSsd(tensorflow: Tensorflow, files: Files): Promise<Detector> {
  const artifacts = readModelFiles(files, COCO_SSD_MODEL);
  // The library hands its URL to `loadGraphModel`, which takes handlers as well.
  const modelUrl = { load: () => Promise.resolve(artifacts) } as unknown as string;
  const model = await tensorflow.run(() => load({ modelUrl }));
  return {
    name: 'COCO-SSD',
    classNames: COCO_CLASSES,
    defaultThreshold: DEFAULTS.threshold,
    detect: async (picture, options = {}) => {
      const resolved = resolveOptions(options, COCO_CLASSES, DEFAULTS);
      const { threshold, maxObjects, classIndices, inputSize } = resolved;
      const { width, height, rgb } = fitModelInput(picture, Math.round(inputSize), 1);
      const found = await tensorflow.run(async () => {
        const image = tf.tensor3d(Int32Array.from(rgb), [height, width, 3]);
        try {
          const count = classIndices === undefined ? maxObjects : MAX_OBJECTS;
          return await model.detect(image, count, threshold);
        } finally {
          image.dispose();
        }
      });
      return found
        .filter((object) => classIndices?.has(COCO_CLASSES.indexOf(object.class)) ?? true)
        .slice(0, maxObjects)
        .map(({ class: name, score, bbox: [x, y, w, h] }) => ({
          class: name,
          score,
          box: boxBetween(x / width, y / height, (x + w) / width, (y + h) / height),
        }));
    },
    dispose: () => model.dispose(),
  };
}
