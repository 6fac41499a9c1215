import { onScopeDispose, shallowRef } from 'vue';
import type { LivePattern } from '../../connection/live/topic-source.ts';
import { useTopic } from '../../connection/live/useTopic.ts';
import { newestRecord } from '../history/topic-feeds.ts';
import { RowValues } from './row-values.ts';

/**
 * Newest values of rows, while the calling scope is active and the page is visible.
 * @param largeRateHz rate of large values, for callers that show more than their size
 */
export function useRowValues(largeRateHz?: number): RowValues {
  const wanted = shallowRef<readonly LivePattern[]>([]);
  const values = new RowValues((topics) => (wanted.value = topics), largeRateHz, newestRecord);
  useTopic(wanted, { keep: 0, onRecord: (record) => values.handleRecord(record) });
  onScopeDispose(() => values.close());
  return values;
}
