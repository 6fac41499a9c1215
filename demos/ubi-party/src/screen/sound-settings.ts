import { useLocalStorage } from '@vueuse/core';

/** What is heard on this screen: kept in the browser, the same for all who ask in a page. */
export function useSoundSettings() {
  return {
    isMuted: useLocalStorage('ubii.party.muted', false),
    isMusicMuted: useLocalStorage('ubii.party.music-muted', false),
  };
}
