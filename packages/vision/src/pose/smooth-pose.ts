import type { BodyPose, Keypoint } from './body-pose.ts';

export interface PoseSmootherOptions {
  /** Time after which a keypoint has gone 63 % of the way to where it is seen; default 80 ms. */
  readonly timeConstantMs?: number;
  /** Score below which a keypoint is not believed: it goes there at once when it is seen again. Default 0.3. */
  readonly minScore?: number;
}

/** Two pictures of a camera of 25 Hz: jitter is halved, and a hand lags by less than it would be noticed. */
const DEFAULT_TIME_CONSTANT_MS = 80;
/** The score from which the example of MoveNet's authors draws keypoints. */
const DEFAULT_MIN_SCORE = 0.3;

/**
 * Makes keypoints calmer: each goes towards where it is seen by an exponential filter. Scores are not
 * changed.
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
