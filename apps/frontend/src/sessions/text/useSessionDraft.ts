import { useSessionStorage } from '@vueuse/core';
import type { Ref } from 'vue';

/** Text of a session being written, kept as long as this tab. */
export function useSessionDraft(): Ref<string> {
  return useSessionStorage('ubii.sessionDraft', '');
}
