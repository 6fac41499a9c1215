import type { UbiiClient } from '@ubii/client-web';
import { useLocalStorage } from '@vueuse/core';
import type { Ref } from 'vue';

/** More tabs are open in few browsers; those that closed fall out. */
const MAX_TABS = 32;

/** Ids of the clients that are, or were, tabs of this browser; the newest last. */
export function useOwnTabs(): Ref<readonly string[]> {
  return useLocalStorage<readonly string[]>('ubii.tabs', []);
}

/** The other tabs of this browser learn of this one. */
export function tellOwnTab(client: Pick<UbiiClient, 'id' | 'onState'>): void {
  const tabs = useOwnTabs();
  client.onState(({ status }) => {
    if (status !== 'connected' || tabs.value.at(-1) === client.id) return;
    tabs.value = [...tabs.value.filter((id) => id !== client.id), client.id].slice(-MAX_TABS);
  });
}
