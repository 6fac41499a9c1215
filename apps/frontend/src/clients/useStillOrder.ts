import { useIntervalFn } from '@vueuse/core';
import { computed, shallowRef, watch, type ComputedRef } from 'vue';

/** How often numbers may move rows, milliseconds: rows that jump cannot be read or pressed. */
const ORDER_MS = 2500;

/**
 * Things in an order that goes by live numbers, and stands still for a while anyway.
 * @param sorted in the order of now
 * @param reasons what puts them into the order of now at once, when it changes
 */
export function useStillOrder<T>(
  sorted: () => readonly T[],
  keyOf: (item: T) => string,
  reasons: () => string,
): ComputedRef<readonly T[]> {
  const turn = shallowRef(0);
  useIntervalFn(() => (turn.value += 1), ORDER_MS);
  const places = shallowRef<ReadonlyMap<string, number>>(new Map());
  watch(
    [turn, reasons],
    () => (places.value = new Map(sorted().map((item, index) => [keyOf(item), index]))),
    { immediate: true },
  );
  const placeOf = (item: T): number => places.value.get(keyOf(item)) ?? Number.MAX_SAFE_INTEGER;
  return computed(() => [...sorted()].sort((a, b) => placeOf(a) - placeOf(b)));
}
