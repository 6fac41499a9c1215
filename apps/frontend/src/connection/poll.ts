import { tryOnScopeDispose, useDocumentVisibility } from '@vueuse/core';
import { ref, toValue, watch, type MaybeRefOrGetter } from 'vue';

/**
 * Calls `ask` at an interval while `enabled` is true and the page is visible, immediately when this starts, and never
 * concurrently: a slow reply delays the next request. `ask` must not reject.
 */
export function usePoll(
  ask: () => Promise<void>,
  intervalMs: MaybeRefOrGetter<number>,
  enabled: MaybeRefOrGetter<boolean>,
): void {
  const visibility = useDocumentVisibility();
  let timer: ReturnType<typeof setTimeout> | undefined;
  const isAsking = ref(false);

  const isOn = (): boolean => toValue(enabled) && visibility.value === 'visible';

  async function run(): Promise<void> {
    clearTimeout(timer);
    timer = undefined;
    if (isAsking.value || !isOn()) return;
    isAsking.value = true;
    await ask();
    isAsking.value = false;
    if (isOn()) timer = setTimeout(() => void run(), toValue(intervalMs));
  }

  watch(isOn, () => void run(), { immediate: true });
  // A shorter interval applies at once.
  watch(
    () => toValue(intervalMs),
    () => {
      if (timer !== undefined) void run();
    },
  );
  tryOnScopeDispose(() => clearTimeout(timer));
}
