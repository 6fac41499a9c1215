import type { PictureSettings } from '../encode-picture.ts';

/** Settings for sending pictures. */
export type PictureStep = Pick<PictureSettings, 'width' | 'quality' | 'rateHz'>;

/** Lowest quality: below, compression hides objects, and smaller pictures lose less. */
const MIN_QUALITY = 0.5;
const QUALITY_STEP = 0.15;
/** Factors on the wanted width. */
const WIDTH_SHARES = [0.75, 0.5, 0.375, 0.25];
const MIN_WIDTH = 160;
/** Factors on the wanted rate. */
const RATE_SHARES = [0.67, 0.5, 0.33, 0.2, 0.1];
const MIN_RATE_HZ = 1;

/**
 * Returns settings from the wanted ones down to the least useful ones. Quality is reduced first, because it costs many
 * bytes and is hardly visible; then size, because models scale pictures down anyway; then rate, because motion is the
 * purpose of live pictures.
 */
export function pictureLadder(wanted: Readonly<PictureSettings>): readonly PictureStep[] {
  let { width, quality, rateHz }: PictureStep = wanted;
  const steps: PictureStep[] = [{ width, quality, rateHz }];
  const add = (): unknown => steps.push({ width, quality, rateHz });
  while (wanted.encoding === 'JPEG' && quality - QUALITY_STEP >= MIN_QUALITY - 1e-9) {
    quality = Math.round((quality - QUALITY_STEP) * 100) / 100;
    add();
  }
  for (const share of WIDTH_SHARES) {
    // JPEG blocks and camera sizes are multiples of 16.
    const next = Math.round((wanted.width * share) / 16) * 16;
    if (next < Math.min(MIN_WIDTH, width)) break;
    width = next;
    add();
  }
  for (const share of RATE_SHARES) {
    const next = wanted.rateHz * share;
    if (next < Math.min(MIN_RATE_HZ, rateHz)) break;
    rateHz = next;
    add();
  }
  return steps;
}

/**
 * Relative bytes per second, measured with JPEG encoders on the photographs of the clip: qualities of 0.35, 0.5, 0.65,
 * 0.8 and 0.95 take 0.45, 0.54, 0.69, 1 and 1.87 times as much, widths of 1, 0.75, 0.5 and 0.25 take 1, 0.56, 0.29 and
 * 0.1.
 */
export function stepCost({ width, quality, rateHz }: PictureStep): number {
  const ofQuality = 0.3 + 0.45 * quality + 1.48 * quality ** 6.6;
  return width ** 1.8 * ofQuality * rateHz;
}
