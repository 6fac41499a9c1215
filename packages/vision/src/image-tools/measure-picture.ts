import { CHANNELS, checkPicture, type Picture } from '../picture.ts';
import { greyPicture } from './convert-picture.ts';

/** Values of a byte. */
const LEVELS = 256;

/**
 * Counts how many pixels have which brightness, for each channel.
 *
 * @param bins into how many equal ranges 0 to 255 is divided, 1 to 256; default 256
 * @returns one array for each channel, in the order of the pixel format; opacity included
 * @throws RangeError when the picture or the number of bins is invalid
 */
export function histogram(picture: Picture, bins: number = LEVELS): Uint32Array[] {
  checkPicture(picture);
  if (!Number.isInteger(bins) || bins < 1 || bins > LEVELS) {
    throw new RangeError(`A histogram has 1 to ${LEVELS} bins, not ${bins}.`);
  }
  const step = CHANNELS[picture.format];
  return Array.from({ length: step }, (_, channel) => {
    const counts = new Uint32Array(bins);
    for (let at = channel; at < picture.data.length; at += step) {
      counts[Math.floor((picture.data[at]! * bins) / LEVELS)]!++;
    }
    return counts;
  });
}

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
