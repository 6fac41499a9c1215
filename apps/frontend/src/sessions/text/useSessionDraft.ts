import { useSessionStorage } from '@vueuse/core';
import type { Ref } from 'vue';

/** The text of a session that is being made; it lives as long as this tab. */
export function useSessionDraft(): Ref<string> {
  return useSessionStorage('ubii.sessionDraft', '');
}
