import { useLocalStorage } from '@vueuse/core';

/** Sound settings of this screen: stored in the browser, shared by all callers in a page. */
export function useSoundSettings() {
  return {
    isMuted: useLocalStorage('ubii.party.muted', false),
    isMusicMuted: useLocalStorage('ubii.party.music-muted', false),
  };
}
