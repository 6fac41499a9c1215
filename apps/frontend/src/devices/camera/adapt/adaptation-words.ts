import { formatBytes } from '../../../ui/readouts/format-bytes.ts';
import { formatNumber } from '../../../ui/readouts/format-number.ts';
import type { PictureSettings } from '../encode-picture.ts';
import { adaptedStep, type AdaptState } from './adapt-pictures.ts';
import { pictureLadder } from './picture-ladder.ts';
import type { SentSummary } from './picture-meter.ts';

/** Ratio of rates from which they count as equal. */
const SAME_RATE = 0.97;
/** Ratio of the sent rate to the decided one below which sending lags behind. */
const BEHIND = 0.8;
/** Share of the interval between pictures from which sending is limited by the network. */
const MUCH_LEAVING = 0.5;

/**
 * Returns how pictures differ from the wanted settings, and why, in one sentence; `undefined` when they do not.
 *
 * @param sent measurements of sent pictures; the text has measured rates, not decided ones
 */
export function adaptationWords(
  state: AdaptState,
  wanted: Readonly<PictureSettings>,
  sent?: SentSummary,
): string | undefined {
  const ladder = pictureLadder(wanted);
  const ofLink = ladder[Math.min(state.level, ladder.length - 1)]!;
  const decidedHz = adaptedStep(state, wanted).rateHz;
  const isBehind = sent !== undefined && sent.rateHz < BEHIND * decidedHz;
  const rateHz = isBehind ? sent.rateHz : decidedHz;
  const isLinksRate = isBehind ? waitsForLink(sent) : decidedHz >= ofLink.rateHz;
  const byLink = [
    ...(ofLink.width < wanted.width ? [`${wanted.width} → ${ofLink.width} px`] : []),
    ...(ofLink.quality < wanted.quality
      ? [`quality ${percent(wanted.quality)} → ${percent(ofLink.quality)} %`]
      : []),
    ...(isLinksRate ? rateChange(wanted.rateHz, rateHz) : []),
  ];
  const byOthers = isLinksRate ? [] : rateChange(wanted.rateHz, rateHz);
  const otherReason = isBehind ? 'this device is busy' : rateReason(state);
  const parts = [
    ...(byLink.length > 0 ? [`${byLink.join(', ')}, because ${linkReason(state, sent)}`] : []),
    ...(byOthers.length > 0 ? [`${byOthers.join()}, because ${otherReason}`] : []),
  ];
  return parts.length === 0 ? undefined : `${parts.join('; ')}.`;
}

function waitsForLink({ leaveMs, rateHz }: SentSummary): boolean {
  return (leaveMs * rateHz) / 1000 > MUCH_LEAVING;
}

/** Throughput before the level was lowered. A slow network and a busy computer cannot be distinguished here. */
function linkReason({ linkBytesPerSecond }: AdaptState, sent: SentSummary | undefined): string {
  const bytesPerSecond = linkBytesPerSecond ?? sent?.bytesPerSecond ?? 0;
  const { digits, unit } = formatBytes(bytesPerSecond, 'B/s');
  return `${digits} ${unit} reach the master`;
}

function rateReason({ moduleHz = Infinity, deviceHz = Infinity, ...state }: AdaptState): string {
  if (moduleHz <= deviceHz)
    return `modules process ${rate(state.resultHz ?? moduleHz)} pictures per second`;
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
