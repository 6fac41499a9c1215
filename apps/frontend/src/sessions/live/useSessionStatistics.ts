import { sessionStatisticsTopic, type SessionStatistics } from '@ubii/proto';
import { computed, type ComputedRef } from 'vue';
import { useTopic } from '../../connection/live/useTopic.ts';
import { useConnection } from '../../connection/useConnection.ts';

/** The newest statistics by the id of their session. */
export type StatisticsById = ReadonlyMap<string, SessionStatistics>;

/**
 * How sessions do, while the calling scope lives; nothing is known while the master is away. [SE-50]
 * @param sessionId one session; without it all of them
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
