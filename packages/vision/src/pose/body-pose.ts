import * as tf from '@tensorflow/tfjs-core';

import { fitModelInput } from '../model-input.ts';
import type { Picture } from '../picture.ts';
import type { Tensorflow } from '../tensorflow/create-tensorflow.ts';
import type { Files } from '../tensorflow/memory-platform.ts';
import { BODY_KEYPOINTS, type BodyKeypointName } from './body-keypoints.ts';

/** The model's file in its asset set. */
export const BODY_POSE_MODEL = 'movenet-lightning.json';

/** A place of a body. */
export interface Keypoint {
  readonly name: BodyKeypointName;
  /** 0 at the left of the picture, 1 at its right. */
  readonly x: number;
  /** 0 at the top of the picture, 1 at its bottom. */
  readonly y: number;
  /** Confidence of the keypoint, 0 to 1. */
  readonly score: number;
}

/** A body in a picture. */
export interface BodyPose {
  /** Mean score of the keypoints; below 0.2 there is hardly a body in the picture. */
  readonly score: number;
  /** All keypoints in the order of `BODY_KEYPOINTS`, those of low score included. */
  readonly keypoints: readonly Keypoint[];
}

/** Finds the keypoints of the body that is most visible in a picture. */
export interface BodyPoseDetector {
  readonly name: string;
  /**
   * Returns the most visible body; without a body, keypoints of low scores anywhere.
   *
   * @throws RangeError when the picture is invalid
   */
  detect(picture: Picture): Promise<BodyPose>;
  /** Frees the memory of the model. */
  dispose(): void;
}

/** Sides of what the model sees, in pixels. From its signature. */
const SIZE = 192;

/**
 * Loads MoveNet SinglePose Lightning, version 4, as `@vladmandic/human` carries it. The model was made
 * for one person near the camera.
 *
 * @param files the model's asset set
 * @throws Error that names the file that is missing or damaged
 */
export async function createBodyPose(
  tensorflow: Tensorflow,
  files: Files,
): Promise<BodyPoseDetector> {
  const model = await tensorflow.loadModel(files, BODY_POSE_MODEL);
  return {
    name: 'MoveNet Lightning',
    detect: async (picture) => {
      const { rgb, pictureWidth, pictureHeight } = fitModelInput(picture, SIZE, SIZE);
      // For each keypoint y, x (0 to 1 of what the model sees) and score.
      const values = await tensorflow.run(async () => {
        const input = tf.tensor4d(Int32Array.from(rgb), [1, SIZE, SIZE, 3]);
        const result = model.execute(input) as tf.Tensor;
        try {
          return await result.data();
        } finally {
          tf.dispose([input, result]);
        }
      });
      const inside = (value: number): number => Math.min(1, Math.max(0, value));
      const keypoints = BODY_KEYPOINTS.map((name, index) => ({
        name,
        x: inside((values[index * 3 + 1]! * SIZE) / pictureWidth),
        y: inside((values[index * 3]! * SIZE) / pictureHeight),
        score: values[index * 3 + 2]!,
      }));
      const score = keypoints.reduce((sum, keypoint) => sum + keypoint.score, 0) / keypoints.length;
      return { score, keypoints };
    },
    dispose: () => model.dispose(),
  };
}

export interface PoseSmootherOptions {
  /** Time constant of the filter: after it, 63 % of a step are reached; default 80 ms. */
  readonly timeConstantMs?: number;
  /** Keypoints with a lower score are not filtered, and filtering starts again after them; default 0.3. */
  readonly minScore?: number;
}

/** Two frames at 25 Hz: a compromise between jitter and lag. */
const DEFAULT_TIME_CONSTANT_MS = 80;
/** The score from which the example of MoveNet's authors draws keypoints. */
const DEFAULT_MIN_SCORE = 0.3;

/**
 * Smooths keypoints with an exponential filter. Scores are not changed.
 */
export class PoseSmoother {
  readonly #timeConstantMs: number;
  readonly #minScore: number;
  #last: readonly Keypoint[] = [];

  constructor({
    timeConstantMs = DEFAULT_TIME_CONSTANT_MS,
    minScore = DEFAULT_MIN_SCORE,
  }: PoseSmootherOptions = {}) {
    this.#timeConstantMs = timeConstantMs;
    this.#minScore = minScore;
  }

  /**
   * Returns the pose, smoothed.
   *
   * @param deltaTimeMs time since the pose before
   */
  smooth(pose: BodyPose, deltaTimeMs: number): BodyPose {
    const share =
      this.#timeConstantMs > 0 ? 1 - Math.exp(-Math.max(0, deltaTimeMs) / this.#timeConstantMs) : 1;
    const keypoints = pose.keypoints.map((seen, index) => {
      const last = this.#last[index];
      if (last === undefined || last.score < this.#minScore || seen.score < this.#minScore) {
        return seen;
      }
      return {
        ...seen,
        x: last.x + (seen.x - last.x) * share,
        y: last.y + (seen.y - last.y) * share,
      };
    });
    this.#last = keypoints;
    return { ...pose, keypoints };
  }
}
