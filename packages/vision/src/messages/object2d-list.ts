import type { Detection } from '../detection/detector.ts';

/** The fields of the message `Object2D` that are set here. */
export interface Object2DValue {
  /** Class of an object, or name of a keypoint. */
  readonly id: string;
  /** Top left corner of a box, or a point; 0 to 1 of the picture's width and height. */
  readonly pose: { readonly position: { readonly x: number; readonly y: number } };
  /** Width and height, 0 to 1; points have none. */
  readonly size?: { readonly x: number; readonly y: number };
  /** JSON text: `{ "score": 0.87 }`. */
  readonly userDataJson: string;
}

/** A value of the data format `object2DList`. */
export interface Object2DListValue {
  readonly elements: readonly Object2DValue[];
}

/** Converts detections to the message that clients draw over the picture. */
export function object2DListOfDetections(detections: readonly Detection[]): Object2DListValue {
  return {
    elements: detections.map(({ class: id, score, box: { x, y, width, height } }) => ({
      id,
      pose: { position: { x, y } },
      size: { x: width, y: height },
      userDataJson: scoreJson(score),
    })),
  };
}

/**
 * Converts keypoints to the message that clients draw over the picture.
 *
 * @param minScore keypoints with a lower score are left out, 0 to 1; keypoints without a score are kept
 */
export function object2DListOfKeypoints(
  keypoints: readonly { name: string; x: number; y: number; score?: number }[],
  minScore = 0,
): Object2DListValue {
  return {
    elements: keypoints
      .filter(({ score = 1 }) => score >= minScore)
      .map(({ name, x, y, score = 1 }) => ({
        id: name,
        pose: { position: { x, y } },
        userDataJson: scoreJson(score),
      })),
  };
}

/** Two digits: more are noise, and the text is sent with every picture. */
function scoreJson(score: number): string {
  return JSON.stringify({ score: Math.round(score * 100) / 100 });
}
