import { useLocalStorage } from '@vueuse/core';
import type { Ref } from 'vue';

/** Setting that disables single-key shortcuts, for speech input and tremor (WCAG 2.1.4). */
export function useSingleKeyShortcuts(): Ref<boolean> {
  return useLocalStorage('ubii.singleKeyShortcuts', true);
}
