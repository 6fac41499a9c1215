import type { TopicRecord } from '@ubii/proto';
import { TopicHistory } from '../../topics/history/topic-history.ts';

/** Viewers ask a history; of a recording it has the one record of the playhead. */
export function historyOf(record: TopicRecord | undefined): TopicHistory {
  const alone = new TopicHistory();
  if (record) alone.add(record, record.timestampMs ?? 0);
  return alone;
}
