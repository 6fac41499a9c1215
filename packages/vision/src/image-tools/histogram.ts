import { CHANNELS, checkPicture, type Picture } from '../picture.ts';

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
