import { computed, type ComputedRef } from 'vue';
import { useRoute, useRouter } from 'vue-router';
import { readWishes, writeWishes, type ClientWishes } from './client-filter.ts';

/** What is wanted to be seen, kept in the address, so that it can be shared and survives a reload. */
export function useClientWishes(): {
  wishes: ComputedRef<ClientWishes>;
  change(changes: Partial<ClientWishes>): void;
} {
  const route = useRoute();
  const router = useRouter();
  const wishes = computed(() => readWishes(route.query));
  return {
    wishes,
    change(changes) {
      const query = writeWishes({ ...wishes.value, ...changes });
      void router.replace({ path: route.path, query });
    },
  };
}
