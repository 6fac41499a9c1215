import { formatFixed } from '../../topics/values/format-value.ts';
import { reachOf } from '../../topics/values/reach.ts';
import { seriesOf } from '../../topics/values/value-series.ts';
import { anglesOf } from '../../topics/viewers/space/describe-things.ts';
import { axesOf } from '../../topics/viewers/space/space-things.ts';
import { formatNumber } from '../../ui/readouts/format-number.ts';
import type { PlayedRecord } from '../opened/played-values.ts';
import { firstFrom } from '../timeline/draw/film-strip.ts';
import type { Track } from '../timeline/track.ts';

/** Tracks that are high enough have a row for each number. */
const MAX_ROWS = 3;
const DECIMALS = 3;

/** The value of a track at the playhead, as rows. */
export function headRows(
  track: Track,
  played: PlayedRecord | undefined,
  frames: Float64Array | undefined,
): readonly string[] {
  const record = played?.record;
  if (record === undefined) return [];
  if (track.kind === 'frames') {
    const number = frames === undefined ? 0 : firstFrom(frames, played!.timeMs + 1e-3);
    return number > 0 ? [`#${number}`] : [];
  }
  if (track.kind === 'bars') return [`${countOf(record.value)} found`];
  if (record.format === 'quaternion')
    return [`yaw ${formatNumber(Math.round(anglesOf(axesOf(record.value)).yaw) + 0)}°`];
  const numbers = seriesOf(record.format)?.read(record.value as never);
  if (numbers && track.heightPx >= 60)
    return numbers
      .slice(0, MAX_ROWS)
      .map((number) => formatFixed(number, DECIMALS, reachOf(numbers)));
  const text = played?.text ?? '';
  return [track.kind === 'ticks' ? eventWord(text) : text];
}

const countOf = (value: unknown): number =>
  (value as { elements?: readonly unknown[] }).elements?.length ?? 1;

/** What happened, without where: `end`, `k down`. */
const eventWord = (text: string): string => text.replace(/^touch_/, '').replace(/ [−-]?\d.*$/, '');
