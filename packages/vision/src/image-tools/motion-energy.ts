import type { Picture } from '../picture.ts';
import { greyPicture } from './convert-picture.ts';

/** Amount of change between two pictures. */
export interface Motion {
  /** Mean change of brightness, 0 (none) to 1 (black to white everywhere). */
  readonly energy: number;
  /** Share of the pixels that changed by the threshold or more, 0 to 1. */
  readonly changedShare: number;
}

/**
 * Default threshold: 10 % of the brightness. The noise of webcams in rooms stays below it (a standard
 * deviation of about 2 %), and moving things mostly exceed it.
 */
const DEFAULT_THRESHOLD = 0.1;

/**
 * Returns how much the brightness changed from one picture to the next.
 *
 * @param threshold change from which a pixel counts as changed, 0 to 1; default 0.1
 * @throws RangeError when a picture is invalid or the sizes differ
 */
export function motionEnergy(
  previous: Picture,
  current: Picture,
  threshold: number = DEFAULT_THRESHOLD,
): Motion {
  if (previous.width !== current.width || previous.height !== current.height) {
    throw new RangeError(
      `Motion needs two pictures of one size, not ${previous.width} × ${previous.height} and ${current.width} × ${current.height}.`,
    );
  }
  const before = greyPicture(previous).data;
  const after = greyPicture(current).data;
  const least = threshold * 255;
  let sum = 0;
  let changed = 0;
  for (let pixel = 0; pixel < after.length; pixel++) {
    const change = Math.abs(after[pixel]! - before[pixel]!);
    sum += change;
    if (change >= least && change > 0) changed++;
  }
  return { energy: sum / 255 / after.length, changedShare: changed / after.length };
}
