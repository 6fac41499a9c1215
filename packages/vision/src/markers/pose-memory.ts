import type { MarkerPose } from './marker-pose.ts';
import { angleBetween, blend } from './rotations.ts';

/** A second solution counts while its error is at most this many times that of the first, or this many pixels more. */
const NEAR_ERROR_RATIO = 2;
const NEAR_ERROR_PX = 0.25;

/** Markers that are not seen for this time are forgotten, milliseconds. */
const FORGET_MS = 500;

interface Seen {
  readonly pose: MarkerPose;
  /** Since it was seen, milliseconds. */
  readonly ageMs: number;
}

/** Poses of the markers of the picture before: which of two solutions goes on, and smoothing. */
export class PoseMemory {
  #before = new Map<string, Seen>();
  /** Undefined for a marker that is there twice: which was which is unknown. */
  #now = new Map<string, Seen | undefined>();

  /** Begins a picture. @param sinceMs since the picture before */
  begin(sinceMs: number): void {
    const seen = new Map([...this.#before, ...this.#now]);
    this.#before = new Map();
    this.#now = new Map();
    for (const [key, one] of seen) {
      const ageMs = (one?.ageMs ?? Infinity) + sinceMs;
      if (one !== undefined && ageMs <= FORGET_MS) this.#before.set(key, { ...one, ageMs });
    }
  }

  /**
   * The pose of a marker. When two explain the picture about equally well, the one nearer to the pose
   * before; otherwise the one with the lower error.
   *
   * @param poses the one with the lower error first
   * @param smoothingMs time constant, 0 for none
   */
  choose(key: string, poses: readonly MarkerPose[], smoothingMs: number): MarkerPose | undefined {
    const [best] = poses;
    if (best === undefined) return undefined;
    const isTwin = this.#now.has(key);
    const before = isTwin ? undefined : this.#before.get(key);
    const chosen = before === undefined ? best : nearestTo(before.pose, best, poses);
    const isSmoothed = before !== undefined && smoothingMs > 0;
    const part = isSmoothed ? 1 - Math.exp(-before.ageMs / smoothingMs) : 1;
    const pose = isSmoothed ? { ...chosen, ...smoothed(before.pose, chosen, part) } : chosen;
    this.#now.set(key, isTwin ? undefined : { pose, ageMs: 0 });
    return pose;
  }
}

function nearestTo(before: MarkerPose, best: MarkerPose, poses: readonly MarkerPose[]): MarkerPose {
  const limitPx = Math.max(best.errorPx * NEAR_ERROR_RATIO, best.errorPx + NEAR_ERROR_PX);
  const angleOf = ({ orientation }: MarkerPose): number =>
    angleBetween(orientation, before.orientation);
  return poses
    .filter(({ errorPx }) => errorPx <= limitPx)
    .reduce((nearest, pose) => (angleOf(pose) < angleOf(nearest) ? pose : nearest), best);
}

function smoothed(before: MarkerPose, now: MarkerPose, part: number) {
  const mix = (from: number, to: number): number => from + (to - from) * part;
  return {
    position: {
      x: mix(before.position.x, now.position.x),
      y: mix(before.position.y, now.position.y),
      z: mix(before.position.z, now.position.z),
    },
    orientation: blend(before.orientation, now.orientation, part),
  };
}
