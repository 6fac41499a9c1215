import type { BodyPose, Keypoint } from './body-pose.ts';

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
