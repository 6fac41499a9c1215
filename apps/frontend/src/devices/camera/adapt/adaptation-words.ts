import { formatBytes } from '../../../ui/readouts/format-bytes.ts';
import { formatNumber } from '../../../ui/readouts/format-number.ts';
import type { PictureSettings } from '../encode-picture.ts';
import { adaptedStep, type AdaptState } from './adapt-pictures.ts';
import { pictureLadder } from './picture-ladder.ts';

/** Smaller differences of the rate are no change. */
const SAME_RATE = 0.97;

/** What is sent otherwise than wanted, and why, in one sentence; `undefined` when nothing is. */
export function adaptationWords(
  state: AdaptState,
  wanted: Readonly<PictureSettings>,
): string | undefined {
  const ladder = pictureLadder(wanted);
  const ofLink = ladder[Math.min(state.level, ladder.length - 1)]!;
  const rateHz = adaptedStep(state, wanted).rateHz;
  const isLinksRate = rateHz >= ofLink.rateHz;
  const byLink = [
    ...(ofLink.width < wanted.width ? [`${wanted.width} → ${ofLink.width} px`] : []),
    ...(ofLink.quality < wanted.quality
      ? [`quality ${percent(wanted.quality)} → ${percent(ofLink.quality)} %`]
      : []),
    ...(isLinksRate ? rateChange(wanted.rateHz, rateHz) : []),
  ];
  const byOthers = isLinksRate ? [] : rateChange(wanted.rateHz, rateHz);
  const parts = [
    ...(byLink.length > 0 ? [`${byLink.join(', ')}, because ${linkReason(state)}`] : []),
    ...(byOthers.length > 0 ? [`${byOthers.join()}, because ${rateReason(state)}`] : []),
  ];
  return parts.length === 0 ? undefined : `${parts.join('; ')}.`;
}

/** What came through before the level was lowered. A slow network and a busy machine look the same from here. */
function linkReason({ linkBytesPerSecond = 0 }: AdaptState): string {
  const { digits, unit } = formatBytes(linkBytesPerSecond, 'B/s');
  return `${digits} ${unit} reach the master`;
}

function rateReason({ moduleHz = Infinity, deviceHz = Infinity, ...state }: AdaptState): string {
  if (moduleHz <= deviceHz)
    return `modules take ${rate(state.resultHz ?? moduleHz)} pictures a second`;
  return 'this device encodes slowly';
}

function rateChange(wantedHz: number, rateHz: number): string[] {
  return rateHz < wantedHz * SAME_RATE ? [`${rate(wantedHz)} → ${rate(rateHz)} Hz`] : [];
}

function rate(hz: number): string {
  return formatNumber(hz, hz < 2.95 && hz % 1 !== 0 ? 1 : 0);
}

function percent(share: number): string {
  return formatNumber(share * 100, 0);
}
