import { isClientId, unnamedClient } from '../../connection/display-names.ts';
import { formatLook } from '../../formats/families.ts';
import { isDataFormat, type DataFormat, type DataFormatFamily } from '@ubii/proto';
import { topicLabel, topicLabels, type NameOf } from './topic-label.ts';
import { trackKind, type TrackKind } from './track-entry.ts';

/** A topic of a recording, as a row of the timeline. */
export interface Track {
  readonly topic: string;
  /** Its last level with the name of its client, and more where that is not enough to tell it. */
  readonly label: string;
  /** The last level of the topic. */
  readonly name: string;
  readonly owner: string;
  readonly format: DataFormat | undefined;
  readonly formatText: string;
  readonly family: DataFormatFamily;
  readonly kind: TrackKind;
  readonly records: number;
  readonly hz: number;
  readonly heightPx: number;
}

/** What a recording says of a topic. */
export interface RecordedTopic {
  readonly topic: string;
  /** Empty for the master. */
  readonly clientId: string;
  readonly format: string;
  readonly records: number;
}

/** Whether a topic has records, not messages of another program, whose format is the name of their schema. */
export function isOwn({ format }: RecordedTopic): boolean {
  return format === '' || isDataFormat(format);
}

const HEIGHTS: Readonly<Record<TrackKind, number>> = {
  ticks: 34,
  lines: 34,
  frames: 56,
  bars: 34,
  text: 34,
  bytes: 34,
};
/** Values of three numbers stand one below the other at their lines. */
const TALL_PX = 68;
const TALL: ReadonlySet<string> = new Set(['vector2', 'vector3']);

/**
 * The tracks of a recording, one for each topic, those of one family and publisher together.
 *
 * @param writers modules that write a topic, for publishers without a name: modules on the master
 */
export function tracksOf(
  topics: readonly RecordedTopic[],
  durationMs: number,
  clientNames: ReadonlyMap<string, string> = new Map(),
  writers: ReadonlyMap<string, string> = new Map(),
): Track[] {
  const nameOf = (id: string): string | undefined =>
    clientNames.get(id) ?? (isClientId(id) ? unnamedClient(id) : undefined);
  const byTopic = new Map<string, RecordedTopic[]>();
  for (const one of topics) byTopic.set(one.topic, [...(byTopic.get(one.topic) ?? []), one]);
  const labels = topicLabels([...byTopic.keys()], nameOf);
  const tracks = [...byTopic].map(([topic, parts]) => ({
    ...trackOf(topic, parts, durationMs),
    owner: ownerOf(
      topic,
      parts,
      nameOf,
      (id) => clientNames.get(id) ?? writers.get(topic) ?? nameOf(id),
    ),
    label: labels.get(topic) ?? topic,
  }));
  return tracks.sort(
    (a, b) => ORDER.indexOf(a.family) - ORDER.indexOf(b.family) || a.topic.localeCompare(b.topic),
  );
}

const ORDER: readonly DataFormatFamily[] = [
  ...(['event', 'vector', 'rotation', 'pose', 'number', 'image'] as const),
  ...(['objects', 'text', 'system'] as const),
];

function trackOf(
  topic: string,
  parts: readonly RecordedTopic[],
  durationMs: number,
): Omit<Track, 'label' | 'owner'> {
  const records = parts.reduce((sum, one) => sum + one.records, 0);
  const { format, family, text } = formatLook(parts[0]?.format ?? '');
  const kind = trackKind(format);
  return {
    topic,
    name: topic.split('/').findLast((level) => level !== '') ?? topic,
    format,
    family,
    kind,
    records,
    formatText: text,
    hz: durationMs > 0 ? (records / durationMs) * 1000 : 0,
    heightPx: format !== undefined && TALL.has(format) ? TALL_PX : HEIGHTS[kind],
  };
}

/** Who published it, or whose id it begins with; where that is not known, where the topic stands. Of a run, whose input or output it is. */
function ownerOf(
  topic: string,
  parts: readonly RecordedTopic[],
  nameOf: NameOf,
  publisherOf: NameOf,
): string {
  const { owner, isOfRun } = topicLabel(topic, nameOf);
  if (isOfRun) return owner;
  const names = new Set(parts.map(({ clientId }) => publisherOf(clientId)).filter(Boolean));
  if (names.size > 0) return [...names].join(', ');
  if (owner !== '') return owner;
  return topic.slice(0, Math.max(0, topic.lastIndexOf('/')));
}

/** Rows from the top, and which of them can be seen. */
export interface TrackRow {
  readonly track: Track;
  readonly topPx: number;
}

export function rowsOf(tracks: readonly Track[]): {
  readonly rows: readonly TrackRow[];
  readonly heightPx: number;
} {
  let topPx = 0;
  const rows = tracks.map((track) => {
    const row = { track, topPx };
    topPx += track.heightPx;
    return row;
  });
  return { rows, heightPx: topPx };
}

/** The rows of a stretch of the list, and one more at either end. */
export function rowsIn(rows: readonly TrackRow[], topPx: number, heightPx: number): TrackRow[] {
  return rows.filter(
    (row) =>
      row.topPx + 2 * row.track.heightPx > topPx &&
      row.topPx - row.track.heightPx < topPx + heightPx,
  );
}

/** Where a list of rows has to be scrolled to, so that all of a row is in view. */
export function scrollShowing(
  { track, topPx }: TrackRow,
  scrolledPx: number,
  heightPx: number,
): number {
  const endPx = topPx + track.heightPx;
  return Math.min(topPx, Math.max(scrolledPx, endPx - heightPx));
}
