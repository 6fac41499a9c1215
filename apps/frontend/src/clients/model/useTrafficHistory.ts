import { computed, watch, type ComputedRef } from 'vue';
import { useConnection } from '../../connection/useConnection.ts';
import { TrafficHistory, type Traffic } from './traffic-history.ts';

/** Traffic of a client since this page was opened; recorded for all clients. */
export function useTrafficHistory(clientId: () => string | undefined): ComputedRef<Traffic> {
  const { reports } = useConnection();
  const history = new TrafficHistory();
  watch(reports.byId, (byId) => byId && history.add(reports.masterTimeMs.value, byId.values()), {
    immediate: true,
    flush: 'sync',
  });
  return computed(() => {
    void reports.byId.value;
    return history.of(clientId() ?? '');
  });
}
