import type { GraphModel } from '@tensorflow/tfjs-converter';
import * as tf from '@tensorflow/tfjs-core';
import { boxBetween, withoutCovered } from '../detection/boxes.ts';
import type { Detection } from '../detection/detector.ts';
import { fitModelInput } from '../model-input.ts';
import type { Picture } from '../picture.ts';

/** Sides of what the model sees, in pixels. From its signature. */
const SIZE = 320;

/** Scores of 7 classes for each box, and boxes (y, x, y, x; 0 to 1 of the input), before the model's own choice. */
const OUTPUTS = [
  'StatefulPartitionedCall/Postprocessor/Slice',
  'StatefulPartitionedCall/Postprocessor/ExpandDims_1',
];

/** Classes of the model (V. Dibia, Handtrack.js 0.1). */
const CLASSES = ['hand', 'fist', 'pinch', 'point', 'face', 'tip', 'pinchtip'] as const;
/** The first four are hands. */
const HAND_CLASSES = 4;

/** Low, because the second model rejects boxes without a hand. */
const THRESHOLD = 0.2;
/** Two hands may touch; two boxes of one hand overlap by more. */
const MAX_OVERLAP = 0.3;

/**
 * Returns where hands may be, the highest score first.
 *
 * @param model `handtrack`
 * @param maxHands most to return
 */
export async function findHandBoxes(
  model: GraphModel,
  picture: Picture,
  maxHands: number,
): Promise<Detection[]> {
  const { rgb, pictureWidth, pictureHeight } = fitModelInput(picture, SIZE, SIZE);
  const input = tf.tensor4d(Int32Array.from(rgb), [1, SIZE, SIZE, 3]);
  const results = (await model.executeAsync(input, OUTPUTS)) as tf.Tensor[];
  const [scores, boxes] = await Promise.all(results.map((result) => result.data()));
  tf.dispose([input, ...results]);
  const [across, down] = [SIZE / pictureWidth, SIZE / pictureHeight];
  const found: Detection[] = [];
  for (let at = 0, box = 0; at < scores!.length; at += CLASSES.length, box += 4) {
    const ofBox = scores!.subarray(at, at + CLASSES.length);
    const score = Math.max(...ofBox.subarray(0, HAND_CLASSES));
    if (!(score >= THRESHOLD) || Math.max(...ofBox) > score) continue;
    const [top, left, bottom, right] = boxes!.subarray(box, box + 4);
    found.push({
      class: 'hand',
      score,
      box: boxBetween(left! * across, top! * down, right! * across, bottom! * down),
    });
  }
  found.sort((a, b) => b.score - a.score);
  return withoutCovered(found, MAX_OVERLAP, maxHands);
}
