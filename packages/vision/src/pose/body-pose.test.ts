import * as tf from '@tensorflow/tfjs-core';
import { beforeAll, describe, expect, it } from 'vitest';

import { readAssetSet } from '../../scripts/asset-sets.mjs';
import { readPhoto } from '../../test/photos.ts';
import { convertPicture } from '../image-tools/convert-picture.ts';
import type { OwnPicture, Picture } from '../picture.ts';
import { createTensorflow, type Tensorflow } from '../tensorflow/create-tensorflow.ts';
import { BODY_BONES, BODY_KEYPOINTS, type BodyKeypointName } from './body-keypoints.ts';
import { createBodyPose, PoseSmoother, type BodyPoseDetector, type BodyPose } from './body-pose.ts';

/**
 * Largest distance of a keypoint from its manually marked position, in heights of the picture. In a face, positions are
 * clear; a shoulder below a space suit or a coat is a guess.
 */
const FACE = 0.03;
const SHOULDER = 0.08;

/** Measured with a ruler on the pictures. */
const SEEN: { file: string; points: [BodyKeypointName, number, number, number][] }[] = [
  {
    file: 'astronaut.jpg',
    points: [
      ['nose', 0.44, 0.25, FACE],
      ['rightEye', 0.395, 0.195, FACE],
      ['leftEye', 0.485, 0.2, FACE],
      ['rightShoulder', 0.19, 0.51, SHOULDER],
      ['leftShoulder', 0.64, 0.54, SHOULDER],
    ],
  },
  {
    file: 'camera.jpg',
    points: [
      ['nose', 0.49, 0.325, FACE],
      ['rightEye', 0.455, 0.285, FACE],
      ['rightEar', 0.365, 0.27, FACE],
      ['rightShoulder', 0.19, 0.35, SHOULDER],
    ],
  },
];

let tensorflow: Tensorflow;
let detector: BodyPoseDetector;
beforeAll(async () => {
  tensorflow = await createTensorflow(readAssetSet('tfjs-wasm'));
  detector = await createBodyPose(tensorflow, readAssetSet('movenet-lightning'));
});

/** The picture in the middle of a black one of twice the width. */
function between(picture: OwnPicture): Picture {
  const { width, height, data } = picture;
  const wide = new Uint8Array(width * 2 * height * 3);
  for (let row = 0; row < height; row++) {
    const line = data.subarray(row * width * 3, (row + 1) * width * 3);
    wide.set(line, (row * 2 * width + width / 2) * 3);
  }
  return { width: width * 2, height, format: 'RGB8', data: wide };
}

describe.each(SEEN)('MoveNet on $file', ({ file, points }) => {
  it('finds the keypoints that a person sees', async () => {
    const { score, keypoints } = await detector.detect(readPhoto(file));
    expect(score).toBeGreaterThan(0.3);
    for (const [name, x, y, tolerance] of points) {
      const found = keypoints.find((keypoint) => keypoint.name === name)!;
      expect(found.score, name).toBeGreaterThan(0.3);
      expect(Math.hypot(found.x - x, found.y - y), name).toBeLessThan(tolerance);
    }
  });
});

describe('MoveNet', () => {
  it('returns all keypoints in the documented order, inside of the picture', async () => {
    const { keypoints } = await detector.detect(readPhoto('chelsea.jpg'));
    expect(keypoints.map(({ name }) => name)).toEqual(BODY_KEYPOINTS);
    for (const { x, y, score } of keypoints) {
      for (const value of [x, y, score]) {
        expect(value).toBeGreaterThanOrEqual(0);
        expect(value).toBeLessThanOrEqual(1);
      }
    }
  });

  it.each(['chelsea.jpg', 'coffee.jpg'])('gives low scores without a body: %s', async (file) => {
    expect((await detector.detect(readPhoto(file))).score).toBeLessThan(0.2);
  });

  it('gives places in the picture whatever its proportions and format', async () => {
    const photo = convertPicture(readPhoto('astronaut.jpg'), 'RGB8');
    const noseOf = async (picture: Picture) => (await detector.detect(picture)).keypoints[0]!;
    const wide = await noseOf(between(photo));
    expect(Math.hypot((wide.x - 0.47) * 2, wide.y - 0.25)).toBeLessThan(FACE * 2);
    const grey = await noseOf(convertPicture(photo, 'GRAY8'));
    expect(Math.hypot(grey.x - 0.44, grey.y - 0.25)).toBeLessThan(FACE * 2);
  });

  it('frees what an inference takes', async () => {
    const before = tf.memory().numTensors;
    await detector.detect(readPhoto('coffee.jpg'));
    expect(tf.memory().numTensors).toBe(before);
  });

  it('refuses a corrupt picture and names a missing file', async () => {
    const data = new Uint8Array(5);
    await expect(detector.detect({ width: 2, height: 2, format: 'RGB8', data })).rejects.toThrow(
      'The picture has 5 bytes instead of 12 (2 × 2 pixels, RGB8).',
    );
    await expect(createBodyPose(tensorflow, {})).rejects.toThrow(
      'The file "movenet-lightning.json" of the model "movenet-lightning.json" is missing.',
    );
  });
});

it('bones join each keypoint to another', () => {
  expect(new Set(BODY_BONES.flat())).toEqual(new Set(BODY_KEYPOINTS));
});

const poseAt = (x: number, score = 0.9): BodyPose => ({
  score,
  keypoints: [{ name: 'nose', x, y: 0.5, score }],
});
const xOf = (pose: BodyPose) => pose.keypoints[0]!.x;

describe('PoseSmoother', () => {
  it('goes 63 % of the way in its time constant, in one step or in many', () => {
    const coarse = new PoseSmoother({ timeConstantMs: 100 });
    coarse.smooth(poseAt(0), 0);
    expect(xOf(coarse.smooth(poseAt(1), 100))).toBeCloseTo(1 - 1 / Math.E);
    const fine = new PoseSmoother({ timeConstantMs: 100 });
    fine.smooth(poseAt(0), 0);
    const last = Array.from({ length: 10 }, () => fine.smooth(poseAt(1), 10)).at(-1)!;
    expect(xOf(last)).toBeCloseTo(1 - 1 / Math.E);
  });

  it('starts where a keypoint is first seen, and where it is seen again', () => {
    const smoother = new PoseSmoother();
    expect(xOf(smoother.smooth(poseAt(0.7), 16))).toBe(0.7);
    expect(xOf(smoother.smooth(poseAt(0.1, 0.05), 16))).toBe(0.1);
    expect(xOf(smoother.smooth(poseAt(0.8), 16))).toBe(0.8);
  });

  it('does nothing with a time constant of 0', () => {
    const smoother = new PoseSmoother({ timeConstantMs: 0 });
    smoother.smooth(poseAt(0), 0);
    expect(xOf(smoother.smooth(poseAt(1), 0))).toBe(1);
  });

  it('stays when no time has passed', () => {
    const smoother = new PoseSmoother();
    smoother.smooth(poseAt(0.2), 0);
    expect(xOf(smoother.smooth(poseAt(1), -5))).toBe(0.2);
  });
});
