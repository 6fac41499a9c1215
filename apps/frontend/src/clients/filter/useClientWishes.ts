import { computed, shallowRef, watch, type ComputedRef } from 'vue';
import { useRoute, useRouter } from 'vue-router';
import { readWishes, writeWishes, type ClientWishes } from './client-filter.ts';

/** Filter, order and view, stored in the URL, so that they can be shared and survive a reload. */
export function useClientWishes(): {
  wishes: ComputedRef<ClientWishes>;
  change(changes: Partial<ClientWishes>): void;
} {
  const route = useRoute();
  const router = useRouter();
  const wishes = shallowRef(readWishes(route.query));
  /** Changes not yet in the URL: typing is faster, and must not lose a letter. */
  let underWay = 0;
  watch(
    () => route.query,
    (query) => {
      if (underWay === 0) wishes.value = readWishes(query);
    },
  );
  return {
    wishes: computed(() => wishes.value),
    change(changes) {
      wishes.value = { ...wishes.value, ...changes };
      underWay += 1;
      void router
        .replace({ path: route.path, query: writeWishes(wishes.value) })
        .finally(() => (underWay -= 1));
    },
  };
}
