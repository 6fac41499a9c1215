import type { UbiiClient } from '@ubii/client-web';
import { useLocalStorage } from '@vueuse/core';
import { shallowRef, watch, type Ref } from 'vue';

/** More tabs are open in few browsers; those that closed fall out. */
const MAX_TABS = 32;

/** Ids of the clients that are, or were, tabs of this browser; the newest last. */
export function useOwnTabs(): Ref<readonly string[]> {
  return useLocalStorage<readonly string[]>('ubii.tabs', []);
}

/** The other tabs of this browser learn of this one. */
export function tellOwnTab(client: Pick<UbiiClient, 'id' | 'onState'>): void {
  const tabs = useOwnTabs();
  const isConnected = shallowRef(false);
  client.onState(({ status }) => (isConnected.value = status === 'connected'));
  // Another tab that wrote at the same moment may have left this one out.
  watch([tabs, isConnected], ([list, connected]) => {
    if (connected && !list.includes(client.id)) tabs.value = [...list, client.id].slice(-MAX_TABS);
  });
}
