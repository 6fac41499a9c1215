import * as tf from '@tensorflow/tfjs-core';
import type { GraphModel } from '@tensorflow/tfjs-converter';
import { fitModelInput, type ModelInput } from '../model-input.ts';
import type { Files } from '../tensorflow/memory-platform.ts';
import type { Tensorflow } from '../tensorflow/create-tensorflow.ts';
import { boxBetween, withoutCovered } from './boxes.ts';
import { COCO_CLASSES } from './coco-classes.ts';
import {
  type Detection,
  type DetectionDefaults,
  type Detector,
  type ResolvedOptions,
  resolveOptions,
} from './detector.ts';

/** The model's file in its asset set. */
export const CENTER_NET_MODEL = 'centernet.json';

/** Names in the model's graph. */
const NODES = {
  /** Pixels, 0 to 255, red green blue. */
  images: 'tower_0/images',
  /** Scores of centres: [1, height / 4, width / 4, 80]. */
  centers: 'tower_0/keypoints',
  /** Distances of a box's sides from its centre, left top right bottom, in pixels of the input. */
  sides: 'tower_0/wh',
  /** Sizes to which the decoder enlarges, constants for 512 × 512, and the share of the input they are. */
  enlarged: [
    { name: 'tower_0/CenternetHead/c5_upsample/up_sampling2d/mul', share: 1 / 16 },
    { name: 'tower_0/CenternetHead/c4_upsample/up_sampling2d_1/mul', share: 1 / 8 },
    { name: 'tower_0/CenternetHead/c3_upsample/up_sampling2d_2/mul', share: 1 / 4 },
  ],
} as const;

/** Pixels of the input between two centres. From the model's signature: 512 / 128. */
const STRIDE = 4;
/** The encoder halves its input five times. */
const STEP = 32;

const DEFAULTS: DetectionDefaults = {
  // On the shipped photographs, all main objects reach it and nothing wrong does.
  threshold: 0.4,
  // Trained with 512; 384 finds the same on these photographs in half the time. Smaller than 128, its
  // coarsest layer has less than 4 × 4 places.
  inputSize: { least: 128, most: 512, usual: 384 },
};

/**
 * Overlap from which two boxes of a class are one object: as in PASCAL VOC's evaluation, a box that
 * covers half of an object has found it. Of its own, the model gives several centres a large object.
 */
const MAX_OVERLAP = 0.5;

/**
 * Loads the CenterNet with MobileNetV3 for the classes of COCO that `@vladmandic/human` carries
 * (X. Zhou et al., "Objects as Points", 2019).
 *
 * @param files the model's asset set
 * @throws Error that names the file that is missing or damaged
 */
export async function createCenterNet(tensorflow: Tensorflow, files: Files): Promise<Detector> {
  const model = await tensorflow.loadModel(withFreeSize(files), CENTER_NET_MODEL);
  return {
    name: 'CenterNet',
    classNames: COCO_CLASSES,
    defaultThreshold: DEFAULTS.threshold,
    detect: async (picture, options = {}) => {
      const resolved = resolveOptions(options, COCO_CLASSES, DEFAULTS);
      const longSide = Math.round(resolved.inputSize / STEP) * STEP;
      const input = fitModelInput(picture, longSide, STEP);
      const { centers, sides } = await tensorflow.run(() => infer(model, input));
      return readCenters(centers, sides, input, resolved);
    },
    dispose: () => model.dispose(),
  };
}

/** The graph accepts one size only, while all of its layers take any: frees the size of its input. */
function withFreeSize(files: Files): Files {
  const bytes = files[CENTER_NET_MODEL];
  if (bytes === undefined) return files;
  const text = new TextDecoder()
    .decode(bytes)
    .replace(
      '"shape":{"shape":{"dim":[{"size":"1"},{"size":"512"},{"size":"512"},{"size":"3"}]}}',
      '"shape":{"shape":{"dim":[{"size":"1"},{"size":"-1"},{"size":"-1"},{"size":"3"}]}}',
    );
  return { ...files, [CENTER_NET_MODEL]: new TextEncoder().encode(text) };
}

async function infer(
  model: GraphModel,
  { width, height, rgb }: ModelInput,
): Promise<{ centers: Float32Array; sides: Float32Array }> {
  const inputs: tf.NamedTensorMap = {
    [NODES.images]: tf.tensor4d(Float32Array.from(rgb), [1, height, width, 3]),
  };
  for (const { name, share } of NODES.enlarged) {
    inputs[name] = tf.tensor1d([height * share, width * share], 'int32');
  }
  const results = model.execute(inputs, [NODES.centers, NODES.sides]) as tf.Tensor[];
  try {
    const [centers, sides] = await Promise.all(results.map((result) => result.data()));
    return { centers: centers as Float32Array, sides: sides as Float32Array };
  } finally {
    tf.dispose(inputs);
    tf.dispose(results);
  }
}

/** A centre is a score that no neighbour of its class exceeds; a box lies around it. */
export function readCenters(
  centers: Float32Array,
  sides: Float32Array,
  { width, height, pictureWidth, pictureHeight }: ModelInput,
  { threshold, maxObjects, classIndices }: ResolvedOptions,
): Detection[] {
  const [columns, rows, classes] = [width / STRIDE, height / STRIDE, COCO_CLASSES.length];
  const detections: Detection[] = [];
  const isPeak = (index: number, row: number, column: number): boolean => {
    for (let y = Math.max(0, row - 1); y <= Math.min(rows - 1, row + 1); y++) {
      for (let x = Math.max(0, column - 1); x <= Math.min(columns - 1, column + 1); x++) {
        const neighbour = index + ((y - row) * columns + x - column) * classes;
        if (centers[neighbour]! > centers[index]!) return false;
      }
    }
    return true;
  };
  for (let index = 0; index < centers.length; index++) {
    if (!(centers[index]! >= threshold)) continue;
    const classIndex = index % classes;
    if (classIndices !== undefined && !classIndices.has(classIndex)) continue;
    const cell = (index - classIndex) / classes;
    const [column, row] = [cell % columns, Math.floor(cell / columns)];
    if (!isPeak(index, row, column)) continue;
    const [x, y] = [column * STRIDE, row * STRIDE];
    const [left, top, right, bottom] = sides.subarray(cell * 4, cell * 4 + 4);
    const box = boxBetween(
      (x - left!) / pictureWidth,
      (y - top!) / pictureHeight,
      (x + right!) / pictureWidth,
      (y + bottom!) / pictureHeight,
    );
    if (box.width > 0 && box.height > 0) {
      detections.push({ class: COCO_CLASSES[classIndex]!, score: centers[index]!, box });
    }
  }
  detections.sort((a, b) => b.score - a.score);
  return withoutCovered(detections, MAX_OVERLAP, maxObjects);
}
