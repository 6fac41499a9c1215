import { useIntervalFn } from '@vueuse/core';
import { computed, shallowRef, watch, type ComputedRef } from 'vue';
import { filterClients, sortClients, type ClientWishes } from './filter/client-filter.ts';
import type { ClientView } from './model/client-view.ts';

/** How often numbers may move rows, milliseconds: rows that jump cannot be read or pressed. */
const ORDER_MS = 2500;

/** The clients that are wanted, in an order that stands still for a while. */
export function useClientOrder(
  views: ComputedRef<readonly ClientView[] | undefined>,
  wishes: ComputedRef<ClientWishes>,
): ComputedRef<readonly ClientView[]> {
  const turn = shallowRef(0);
  useIntervalFn(() => (turn.value += 1), ORDER_MS);
  const order = shallowRef<ReadonlyMap<string, number>>(new Map());
  const found = computed(() => filterClients(views.value ?? [], wishes.value));
  const members = computed(() => (views.value ?? []).map(({ client }) => client.id).join());
  watch(
    [turn, members, () => wishes.value.sort, () => wishes.value.isDescending],
    () => {
      const sorted = sortClients(views.value ?? [], wishes.value);
      order.value = new Map(sorted.map(({ client }, index) => [client.id, index]));
    },
    { immediate: true },
  );
  const placeOf = ({ client }: ClientView): number => order.value.get(client.id) ?? Infinity;
  return computed(() => [...found.value].sort((a, b) => placeOf(a) - placeOf(b)));
}
