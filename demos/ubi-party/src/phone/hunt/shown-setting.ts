import { useLocalStorage } from '@vueuse/core';
import type { Ref } from 'vue';

/** Whether this player shows photos on the big screen: off until they say so, then as they said last. */
export function useShownSetting(): Ref<boolean> {
  return useLocalStorage('ubii.party.shows-photos', false);
}
