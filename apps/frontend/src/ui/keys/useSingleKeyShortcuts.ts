import { useLocalStorage } from '@vueuse/core';
import type { Ref } from 'vue';

/** Single keys can be switched off, for people who speak or shake their input (WCAG 2.1.4). */
export function useSingleKeyShortcuts(): Ref<boolean> {
  return useLocalStorage('ubii.singleKeyShortcuts', true);
}
