import type { GraphModel } from '@tensorflow/tfjs-converter';
import * as tf from '@tensorflow/tfjs-core';

import { boxBetween, withoutCovered } from '../detection/boxes.ts';
import type { Detection } from '../detection/detector.ts';
import { convertPicture } from '../image-tools/convert-picture.ts';
import {
  cutSquare,
  placeInPicture,
  scalePicture,
  type TurnedSquare,
} from '../image-tools/crop-and-scale.ts';
import { fitModelInput } from '../model-input.ts';
import { checkPicture, type Picture } from '../picture.ts';
import type { Tensorflow } from '../tensorflow/create-tensorflow.ts';
import type { Files } from '../tensorflow/memory-platform.ts';
import { HAND_KEYPOINTS, type HandKeypointName } from './hand-keypoints.ts';

/** Sides of what the model sees, in pixels. From its signature. */
const DETECTOR_SIZE = 320;

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
async function findHandBoxes(
  model: GraphModel,
  picture: Picture,
  maxHands: number,
): Promise<Detection[]> {
  const { rgb, pictureWidth, pictureHeight } = fitModelInput(picture, DETECTOR_SIZE, DETECTOR_SIZE);
  const input = tf.tensor4d(Int32Array.from(rgb), [1, DETECTOR_SIZE, DETECTOR_SIZE, 3]);
  const results = (await model.executeAsync(input, OUTPUTS)) as tf.Tensor[];
  const [scores, boxes] = await Promise.all(results.map((result) => result.data()));
  tf.dispose([input, ...results]);
  const [across, down] = [DETECTOR_SIZE / pictureWidth, DETECTOR_SIZE / pictureHeight];
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

/** The models' files in their asset set. */
export const HAND_POSE_MODELS = {
  boxes: 'handtrack.json',
  keypoints: 'handlandmark-lite.json',
} as const;

/** A place of a hand. */
export interface HandKeypoint {
  readonly name: HandKeypointName;
  /** 0 at the left of the picture, 1 at its right; may be outside. */
  readonly x: number;
  /** 0 at the top of the picture, 1 at its bottom; may be outside. */
  readonly y: number;
  /**
   * Metres from the middle of the hand, for a hand of average size: x to the right and y downwards in
   * the picture, z away from the camera.
   */
  readonly metric: { readonly x: number; readonly y: number; readonly z: number };
}

/** A hand in a picture. */
export interface HandPose {
  /** Confidence of the hand, 0 to 1. Single keypoints have no score. */
  readonly score: number;
  /** Side of the hand, if the picture is not mirrored. */
  readonly side: 'left' | 'right';
  /** In the order of `HAND_KEYPOINTS`. */
  readonly keypoints: readonly HandKeypoint[];
}

export interface HandPoseOptions {
  /** Most hands, 1 to 10; default 2. */
  readonly maxHands?: number;
  /** Least score, 0 to 1; default 0.5. */
  readonly threshold?: number;
}

/** Finds hands and their keypoints in pictures. */
export interface HandPoseDetector {
  readonly name: string;
  /**
   * Returns the hands in a picture, the highest score first.
   *
   * @throws RangeError when the picture is invalid
   */
  detect(picture: Picture, options?: HandPoseOptions): Promise<HandPose[]>;
  /** Frees the memory of the models. */
  dispose(): void;
}

/** Sides of what the second model sees, in pixels. From its signature. */
const SIZE = 224;
/** Side of the square that the second model sees, relative to the hand: drawn hands score best with it. */
const MARGIN = 1.5;
/** Larger pictures are reduced first: a hand of a quarter of the width still has 240 pixels. */
const MAX_LONG_SIDE = 960;
/** Below this angle (15°), turning the hand upright does not improve the result. */
const MIN_TURN = Math.PI / 12;
const DEFAULT_THRESHOLD = 0.5;
const MAX_HANDS = 10;
const USUAL_HANDS = 2;
const NAMES_OF_OUTPUTS = ['Identity', 'Identity_1', 'Identity_2', 'Identity_3'];

/**
 * Loads the models for hands that `@vladmandic/human` carries: Handtrack, which finds boxes of hands, and
 * MediaPipe's hand landmarks (lite), which finds the keypoints in a box.
 *
 * @param files the models' asset set
 * @throws Error that names the file that is missing or damaged
 */
export async function createHandPose(
  tensorflow: Tensorflow,
  files: Files,
): Promise<HandPoseDetector> {
  const boxes = await tensorflow.loadModel(files, HAND_POSE_MODELS.boxes);
  const keypoints = await tensorflow.loadModel(files, HAND_POSE_MODELS.keypoints);
  return {
    name: 'Handtrack and MediaPipe hand landmarks',
    detect: async (picture, options = {}) => {
      const maxHands = Math.round(clamp(options.maxHands, 1, MAX_HANDS, USUAL_HANDS));
      const threshold = clamp(options.threshold, 0, 1, DEFAULT_THRESHOLD);
      const reduced = reduce(picture);
      return tensorflow.run(async () => {
        const hands: HandPose[] = [];
        for (const { box } of await findHandBoxes(boxes, reduced, maxHands)) {
          const hand = await findKeypoints(keypoints, reduced, {
            x: (box.x + box.width / 2) * reduced.width,
            y: (box.y + box.height / 2) * reduced.height,
            side: Math.max(box.width * reduced.width, box.height * reduced.height) * MARGIN,
            angle: 0,
          });
          if (hand.score >= threshold) hands.push(hand);
        }
        return hands.sort((a, b) => b.score - a.score);
      });
    },
    dispose: () => {
      boxes.dispose();
      keypoints.dispose();
    },
  };
}

function reduce(picture: Picture): Picture {
  checkPicture(picture);
  const scale = Math.min(1, MAX_LONG_SIDE / Math.max(picture.width, picture.height));
  const [width, height] = [picture.width, picture.height].map((side) =>
    Math.max(1, Math.round(side * scale)),
  );
  return convertPicture(scale < 1 ? scalePicture(picture, width!, height!) : picture, 'RGB8');
}

/** Reads the keypoints, then again with the fingers upwards, which the model was trained with. */
async function findKeypoints(
  model: GraphModel,
  picture: Picture,
  square: TurnedSquare,
): Promise<HandPose> {
  const asSeen = await readSquare(model, picture, square);
  const [wrist, root] = ['wrist', 'middleMcp'].map((name) =>
    asSeen.keypoints.find((keypoint) => keypoint.name === name)!,
  );
  const angle = Math.atan2(
    (root!.x - wrist!.x) * picture.width,
    (wrist!.y - root!.y) * picture.height,
  );
  if (!(Math.abs(angle) >= MIN_TURN)) return asSeen;
  const upright = await readSquare(model, picture, { ...square, angle });
  return upright.score > asSeen.score ? upright : asSeen;
}

async function readSquare(
  model: GraphModel,
  picture: Picture,
  square: TurnedSquare,
): Promise<HandPose> {
  const { data } = cutSquare(picture, square, SIZE);
  const input = tf.tidy(() =>
    tf.div(tf.tensor4d(Float32Array.from(data), [1, SIZE, SIZE, 3]), 255),
  );
  const results = model.execute(input, NAMES_OF_OUTPUTS) as tf.Tensor[];
  const [places, score, side, metric] = await Promise.all(results.map((result) => result.data()));
  tf.dispose([input, ...results]);
  const [cos, sin] = [Math.cos(square.angle), Math.sin(square.angle)];
  const keypoints = HAND_KEYPOINTS.map((name, index) => {
    // x, y and depth for each keypoint; pixels of the square, and metres.
    const at = index * 3;
    const { x, y } = placeInPicture(square, places![at]! / SIZE, places![at + 1]! / SIZE);
    const [mx, my, mz] = metric!.subarray(at, at + 3);
    return {
      name,
      x: x / picture.width,
      y: y / picture.height,
      metric: { x: mx! * cos - my! * sin, y: mx! * sin + my! * cos, z: mz! },
    };
  });
  // The model expects mirrored pictures, in which high values mean right hands.
  return { score: score![0]!, side: side![0]! > 0.5 ? 'left' : 'right', keypoints };
}

function clamp(value: number | undefined, least: number, most: number, fallback: number): number {
  return Math.min(most, Math.max(least, Number.isFinite(value) ? value! : fallback));
}
