import { computed, type ComputedRef } from 'vue';
import { filterClients, sortClients, type ClientWishes } from './filter/client-filter.ts';
import type { ClientView } from './model/client-view.ts';
import { useStillOrder } from './model/useStillOrder.ts';

/** Filtered clients, in an order that is stable for some time. */
export function useClientOrder(
  views: ComputedRef<readonly ClientView[] | undefined>,
  wishes: ComputedRef<ClientWishes>,
): ComputedRef<readonly ClientView[]> {
  const sorted = computed(() =>
    sortClients(filterClients(views.value ?? [], wishes.value), wishes.value),
  );
  return useStillOrder(
    () => sorted.value,
    ({ client }) => client.id,
    () => {
      const { sort, isDescending } = wishes.value;
      const ids = (views.value ?? []).map(({ client }) => client.id).join();
      // The first report replaces unknown values by numbers: sort again.
      const isMeasured = views.value?.some(({ activity }) => activity !== undefined) ?? false;
      return `${sort} ${isDescending} ${isMeasured} ${ids}`;
    },
  );
}
