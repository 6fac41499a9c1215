import { sessionStatisticsTopic, type SessionStatistics } from '@ubii/proto';
import { computed, type ComputedRef } from 'vue';
import { useTopic } from '../../connection/live/useTopic.ts';
import { useConnection } from '../../connection/useConnection.ts';

/** Newest statistics by session id. */
export type StatisticsById = ReadonlyMap<string, SessionStatistics>;

/**
 * Statistics of sessions, while the calling scope is active; empty while the master is disconnected. [SE-50]
 * @param sessionId one session; default: all
 */
export function useSessionStatistics(sessionId = '*'): ComputedRef<StatisticsById> {
  const { isConnected } = useConnection();
  const { byTopic } = useTopic(
    () => (isConnected.value ? { glob: sessionStatisticsTopic(sessionId) } : undefined),
    { format: 'sessionStatistics' },
  );
  return computed(
    () => new Map(Array.from(byTopic.value.values(), ({ value }) => [value.sessionId, value])),
  );
}
