import type { RecordingTopic } from '@ubii/proto';
import { tracksOf, type Track } from '../timeline/track.ts';

/** What is recorded at a moment. */
export interface RunningTopics {
  readonly atMs: number;
  readonly topics: readonly RecordingTopic[];
}

/** A topic that is being recorded. */
export interface RunningTopic extends Pick<
  Track,
  'topic' | 'label' | 'owner' | 'formatText' | 'records'
> {
  /** Records per second since the moment before; undefined at first. */
  readonly hz: number | undefined;
}

/** The topics of a running recording, in the order of the timeline, with their rates. */
export function runningTopics(
  before: RunningTopics | undefined,
  now: RunningTopics,
  writers: ReadonlyMap<string, string>,
): RunningTopic[] {
  const names = now.topics.map(({ clientId, clientName }) => [clientId, clientName] as const);
  const clientNames = new Map(names.filter(([id, name]) => id !== '' && name !== ''));
  const topics = now.topics.map(({ topic, clientId, dataFormat, recordCount }) => {
    return { topic, clientId, format: dataFormat, records: recordCount };
  });
  const old = before && countsOf(before);
  const seconds = before && (now.atMs - before.atMs) / 1000;
  return tracksOf(topics, 0, clientNames, writers).map(
    ({ topic, label, owner, formatText, records }) => ({
      topic,
      label,
      owner,
      formatText,
      records,
      hz: old && seconds ? (records - (old.get(topic) ?? 0)) / seconds : undefined,
    }),
  );
}

function countsOf({ topics }: RunningTopics): Map<string, number> {
  const counts = new Map<string, number>();
  for (const { topic, recordCount } of topics)
    counts.set(topic, (counts.get(topic) ?? 0) + recordCount);
  return counts;
}
