import * as tf from '@tensorflow/tfjs-core';
import { beforeAll, describe, expect, it } from 'vitest';
import { readAssetSet } from '../../scripts/asset-sets.mjs';
import { HAND_POINTS, handPicture } from '../hand-picture.ts';
import { readPhoto } from '../../test/photos.ts';
import { cutSquare } from '../image-tools/crop-and-scale.ts';
import { createTensorflow, type Tensorflow } from '../tensorflow/create-tensorflow.ts';
import { HAND_BONES, HAND_KEYPOINTS } from './hand-keypoints.ts';
import { createHandPose, type HandPose, type HandPoseDetector } from './hand-pose.ts';

/** Mean distance of keypoints from where they were drawn, in sides of the hand's square. */
const TOLERANCE = 0.08;

let tensorflow: Tensorflow;
let detector: HandPoseDetector;
beforeAll(async () => {
  tensorflow = await createTensorflow(readAssetSet('tfjs-wasm'));
  detector = await createHandPose(tensorflow, readAssetSet('hand-pose'));
});

const HAND = { x: 70, y: 50, side: 170 };

/** @param placeOf where a point of the hand's square was drawn, in pixels */
function meanError(
  { keypoints }: HandPose,
  size: { width: number; height: number },
  placeOf: (x: number, y: number) => readonly [number, number],
): number {
  const errors = keypoints.map((found, index) => {
    const [x, y] = placeOf(...HAND_POINTS[index]!);
    return Math.hypot(found.x * size.width - x, found.y * size.height - y) / HAND.side;
  });
  return errors.reduce((sum, error) => sum + error, 0) / errors.length;
}

describe('hand poses', () => {
  it('finds the keypoints of a hand where they were drawn, and its size', async () => {
    const scene = handPicture(420, 300, HAND);
    const hands = await detector.detect(scene);
    expect(hands).toHaveLength(1);
    expect(hands[0]!.score).toBeGreaterThan(0.9);
    expect(hands[0]!.keypoints.map(({ name }) => name)).toEqual(HAND_KEYPOINTS);
    const error = meanError(hands[0]!, scene, (x, y) => [
      HAND.x + x * HAND.side,
      HAND.y + y * HAND.side,
    ]);
    expect(error).toBeLessThan(TOLERANCE);

    // Metres: hands of adults are 17 to 20 cm long, of which the model takes some for bent.
    const [wrist, tip] = [hands[0]!.keypoints[0]!.metric, hands[0]!.keypoints[12]!.metric];
    const length = Math.hypot(tip.x - wrist.x, tip.y - wrist.y, tip.z - wrist.z);
    expect(length).toBeGreaterThan(0.1);
    expect(length).toBeLessThan(0.2);
    expect(tip.y).toBeLessThan(wrist.y);
  });

  it.each([-0.8, Math.PI / 2])('finds a hand that is turned by %f', async (angle) => {
    const upright = handPicture(320, 320, { ...HAND, x: 75, y: 75 });
    const scene = cutSquare(upright, { x: 160, y: 160, side: 320, angle: -angle }, 320);
    const [hand] = await detector.detect(scene);
    const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
    const error = meanError(hand!, scene, (x, y) => {
      const [dx, dy] = [(x - 0.5) * HAND.side, (y - 0.5) * HAND.side];
      return [160 + dx * cos - dy * sin, 160 + dx * sin + dy * cos];
    });
    expect(error).toBeLessThan(TOLERANCE);
  });

  it('tells left from right by the thumb', async () => {
    const [left] = await detector.detect(handPicture(320, 300, HAND));
    const [right] = await detector.detect(handPicture(320, 300, { ...HAND, isMirrored: true }));
    expect([left!.side, right!.side]).toEqual(['left', 'right']);
  });

  it.each(['astronaut.jpg', 'chelsea.jpg'])('finds none in %s', async (file) => {
    expect(await detector.detect(readPhoto(file))).toEqual([]);
  });

  it('keeps to threshold, and frees what an inference takes', async () => {
    const before = tf.memory().numTensors;
    expect(await detector.detect(handPicture(320, 300, HAND), { threshold: 1 })).toEqual([]);
    expect(tf.memory().numTensors).toBe(before);
  });

  it('refuses a corrupt picture and names a missing file', async () => {
    const data = new Uint8Array(5);
    await expect(detector.detect({ width: 2, height: 2, format: 'RGB8', data })).rejects.toThrow(
      'The picture has 5 bytes instead of 12 (2 × 2 pixels, RGB8).',
    );
    await expect(createHandPose(tensorflow, {})).rejects.toThrow('The file "handtrack.json"');
  });
});

it('bones join each keypoint to another', () => {
  expect(new Set(HAND_BONES.flat())).toEqual(new Set(HAND_KEYPOINTS));
});
