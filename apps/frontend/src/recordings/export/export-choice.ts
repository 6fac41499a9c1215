import { plural } from '@ubii/words';
import { isOwn, tracksOf, type RecordedTopic, type Track } from '../timeline/track.ts';
import { formatNumber } from '../../ui/readouts/format-number.ts';
import type { ExportFormat } from './export-messages.ts';

/** Formats, and what people get. */
export const EXPORT_FORMATS: readonly {
  readonly value: ExportFormat;
  readonly text: string;
  readonly hint: string;
}[] = [
  {
    value: 'csv',
    text: 'CSV',
    hint: 'A table for each topic, for spreadsheets and scripts. It can be opened here again.',
  },
  {
    value: 'parquet',
    text: 'Parquet',
    hint: 'A typed table for each topic, for pandas, DuckDB and R.',
  },
  {
    value: 'xdf',
    text: 'XDF',
    hint: 'One file for EEGLAB and MNE, with the offsets of all clocks.',
  },
  {
    value: 'mcap',
    text: 'MCAP',
    hint: 'A recording of its own, bit for bit, with sessions, clocks and markers.',
  },
  {
    value: 'video',
    text: 'Video',
    hint: 'A film for each topic with images, by the times at which they were recorded.',
  },
];

/** What a format is for. @param isTreated personal data is replaced, so that not every bit is as recorded */
export function formatHint(format: ExportFormat, isTreated: boolean): string {
  const { hint } = EXPORT_FORMATS.find(({ value }) => value === format)!;
  return isTreated ? hint.replace(', bit for bit', '') : hint;
}

/** Topics that can be exported in a format. Messages of other programs have no values: only MCAP has them. */
export function exportableTopics(
  topics: readonly RecordedTopic[],
  format: ExportFormat,
  durationMs: number,
  clientNames?: ReadonlyMap<string, string>,
): readonly Track[] {
  const possible = format === 'mcap' ? topics : topics.filter(isOwn);
  const tracks = tracksOf(possible, durationMs, clientNames);
  if (format !== 'video') return tracks;
  return tracks.filter((one) => one.format === 'image2D' || one.format === 'image2DList');
}

/** A topic as a row to choose. */
export const topicOption = ({ topic, label, formatText, records }: Track) => ({
  value: topic,
  text: label,
  detail: [formatText, `${formatNumber(records)} ${plural(records, 'record')}`]
    .filter(Boolean)
    .join(', '),
});

/** Why a format is not available here, one sentence. */
export function formatRefusal(
  format: ExportFormat,
  topics: readonly Track[],
  hasEncoder: boolean,
): string | undefined {
  if (format === 'video' && topics.length === 0) return 'The recording has no topic with images.';
  if (format === 'video' && !hasEncoder)
    return 'This browser cannot encode video here. Use a current Chrome, Edge or Safari, over HTTPS or on the computer of the master.';
  return topics.length === 0 ? 'The recording has no topic that can be exported.' : undefined;
}
