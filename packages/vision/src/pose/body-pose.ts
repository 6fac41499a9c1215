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
