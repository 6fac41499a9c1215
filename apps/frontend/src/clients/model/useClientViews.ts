import { computed, type ComputedRef } from 'vue';
import { useMasters } from '../../connection/useMasters.ts';
import { useConnection } from '../../connection/useConnection.ts';
import { viewClient, type ClientView } from './client-view.ts';

/** Interval of requests while the page is visible, milliseconds. */
const REPORT_MS = 700;

/** All clients with their statistics, updated while the calling component is mounted. */
export function useClientViews(): ComputedRef<readonly ClientView[] | undefined> {
  const { client, clients, reports, master } = useConnection();
  const masters = useMasters();
  reports.watch(REPORT_MS);
  return computed(() => {
    const activities = reports.byId.value;
    const problems = (master.view.value?.latest.problems ?? []).filter(({ clientId }) => clientId);
    return clients.list.value?.map((one) => {
      const masterName = masters.labelOf(one.extension?.masterId);
      return viewClient(one, activities?.get(one.id), problems, client.id, masterName);
    });
  });
}
