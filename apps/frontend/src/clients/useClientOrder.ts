import { computed, type ComputedRef } from 'vue';
import { filterClients, sortClients, type ClientWishes } from './filter/client-filter.ts';
import type { ClientView } from './model/client-view.ts';
import { useStillOrder } from './useStillOrder.ts';

/** The clients that are wanted, in an order that stands still for a while. */
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
      // The first report changes what is unknown into numbers
      const isMeasured = views.value?.some(({ activity }) => activity !== undefined) ?? false;
      return `${sort} ${isDescending} ${isMeasured} ${ids}`;
    },
  );
}
