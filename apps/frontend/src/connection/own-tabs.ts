import type { UbiiClient } from '@ubii/client-web';
import { useLocalStorage } from '@vueuse/core';
import { shallowRef, watch, type Ref } from 'vue';

/** Most tabs remembered; closed ones are dropped first. */
const MAX_TABS = 32;

/** Client ids of current and former tabs of this browser; newest last. */
export function useOwnTabs(): Ref<readonly string[]> {
  return useLocalStorage<readonly string[]>('ubii.tabs', []);
}

/** Adds this tab to the list for the browser's other tabs. */
export function tellOwnTab(client: Pick<UbiiClient, 'id' | 'onState'>): void {
  const tabs = useOwnTabs();
  const isConnected = shallowRef(false);
  client.onState(({ status }) => (isConnected.value = status === 'connected'));
  // Another tab may have overwritten the list without this one at the same moment.
  watch([tabs, isConnected], ([list, connected]) => {
    if (connected && !list.includes(client.id)) tabs.value = [...list, client.id].slice(-MAX_TABS);
  });
}
