import { useMediaQuery } from '@vueuse/core';
import { computed, shallowRef, watch, type ComputedRef } from 'vue';
import { useRoute } from 'vue-router';

/** What a page with a list has opened. */
export interface Opened {
  /** Id in the address. */
  readonly named: ComputedRef<string | undefined>;
  /** Id of what is shown beside the list: that of the address, else on wide screens the first of the list. */
  readonly shown: ComputedRef<string | undefined>;
  readonly isNarrow: ComputedRef<boolean>;
}

/**
 * Opens the first thing of a list that has room for its details. It stays opened while the list has it, whatever its order becomes.
 *
 * @param param name of the route's parameter that has the id
 * @param ids ids of the list in its order
 * @param isThere for lists that show a part of what they have, such as trees: whether they still have what was opened
 */
export function useOpened(
  param: string,
  ids: () => readonly string[],
  isThere = (id: string): boolean => ids().includes(id),
): Opened {
  const route = useRoute();
  const isPhone = useMediaQuery('(max-width: 759px)');
  const named = computed(() => {
    const id = route.params[param];
    return typeof id === 'string' && id !== '' ? id : undefined;
  });
  const first = shallowRef<string>();
  watch(
    [ids, named] as const,
    ([list, id]) => {
      // The one that was opened last is the first when the address names none.
      if (id !== undefined) first.value = id;
      else if (first.value === undefined || !isThere(first.value)) first.value = list[0];
    },
    { immediate: true },
  );
  return {
    named,
    shown: computed(() => named.value ?? (isPhone.value ? undefined : first.value)),
    isNarrow: computed(() => isPhone.value),
  };
}
