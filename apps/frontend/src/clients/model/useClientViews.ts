import { computed, type ComputedRef } from 'vue';
import { useConnection } from '../../connection/useConnection.ts';
import { viewClient, type ClientView } from './client-view.ts';

/** How often clients are asked about while the page is seen, milliseconds. */
const REPORT_MS = 700;

/** Every client with what it does, kept fresh while the calling component lives. */
export function useClientViews(): ComputedRef<readonly ClientView[] | undefined> {
  const { client, clients, reports, master } = useConnection();
  reports.watch(REPORT_MS);
  return computed(() => {
    const activities = reports.byId.value;
    const problems = (master.view.value?.latest.problems ?? []).filter(({ clientId }) => clientId);
    return clients.list.value?.map((one) =>
      viewClient(one, activities?.get(one.id), problems, client.id),
    );
  });
}
