import { useIntervalFn } from '@vueuse/core';
import { computed, shallowRef, watch, type ComputedRef } from 'vue';

/** Shortest interval between changes of the order, milliseconds: moving rows cannot be read or clicked. */
const ORDER_MS = 2500;

/**
 * Sorts items by live numbers, and keeps the order for some time.
 * @param sorted items in the current order
 * @param reasons a change of these applies the current order at once
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
