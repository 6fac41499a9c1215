import { compileGlob } from '@ubii/patterns';
import type { TopicRecord } from '@ubii/proto';
import type { OutlineReader, RecordingOutline, TopicOutline } from '@ubii/recording';
import { decodeRecorded } from '../reading/decode-recorded.ts';
import { clientNamesOf, labelsOf } from '../reading/opened-recording.ts';
import { TimeBase } from '../reading/recording-time-base.ts';
import { tracksOf } from '../timeline/track.ts';
import { PREVIEW_PARTS, type PreviewTrack, type RecordingPreview } from './preview-messages.ts';

/** Topics with a strip of their own. */
const MAX_TRACKS = 5;
/** Largest chunk that is read for a picture. */
const MAX_PICTURE_BYTES = 4 * 1024 * 1024;

/** A preview, and the record of its picture, which takes a read of its own. */
export interface ReadPreview {
  readonly preview: RecordingPreview;
  /** Undefined when it cannot be read. */
  pictureRecord(): Promise<TopicRecord | undefined>;
}

/** Reads what a list shows of a recording. */
export async function readPreview(reader: OutlineReader): Promise<ReadPreview> {
  const outline = await reader.outline(PREVIEW_PARTS);
  const { startNs, endNs, topics, markers, activity } = outline;
  const base = new TimeBase(startNs);
  const durationMs = base.toMs(endNs);
  const pictured = pictureTopic(outline);
  const preview: RecordingPreview = {
    durationMs,
    activity,
    records: topics.reduce((sum, { records }) => sum + records, 0),
    topics: new Set(topics.map(({ topic }) => topic)).size,
    tracks: busiest(topics, durationMs),
    markers: markers.map(({ timeMs, text }) => ({ timeMs: base.placed(timeMs), text })),
    hasPicture: pictured !== undefined,
  };
  return {
    preview,
    async pictureRecord() {
      if (pictured === undefined) return undefined;
      const middleNs = base.toNs(durationMs / 2);
      const found = await reader.recordNear(pictured, middleNs, MAX_PICTURE_BYTES);
      return found && decodeRecorded(pictured, found.record);
    },
  };
}

function busiest(topics: readonly TopicOutline[], durationMs: number): PreviewTrack[] {
  const named = topics.map((one) => (one.isRaw ? { ...one, format: one.schemaName } : one));
  const tracks = tracksOf(named, durationMs, clientNamesOf({ topics, clients: [] }));
  return tracks
    .sort((a, b) => b.records - a.records)
    .slice(0, MAX_TRACKS)
    .map(({ topic, label, family, records }) => {
      const activity = new Float32Array(PREVIEW_PARTS);
      for (const part of topics.filter((one) => one.topic === topic))
        part.activity.forEach((count, i) => (activity[i]! += count));
      return { topic, label, family, records, activity };
    });
}

/** The image topic with the most records. Topics that a label of personal data names are left out. [PD-7] */
function pictureTopic({ header, topics }: RecordingOutline): string | undefined {
  const personal = labelsOf(header).map(({ topicPattern }) => compileGlob(topicPattern));
  const pictured = topics.filter(
    ({ topic, format, isRaw, records }) =>
      !isRaw &&
      records > 0 &&
      (format === 'image2D' || format === 'image2DList') &&
      !personal.some((matches) => matches(topic)),
  );
  return pictured.sort((a, b) => b.records - a.records)[0]?.topic;
}
