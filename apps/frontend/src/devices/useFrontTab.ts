import { useEventListener } from '@vueuse/core';
import { onScopeDispose, shallowReactive, shallowRef, type ShallowRef } from 'vue';
import { FrontTab } from './front-tab.ts';

/** Names of the devices of this page that another tab has as well, and rests with. */
const elsewhere = shallowReactive(new Set<string>());

/** Whether another tab of this browser rests while this one is in front. [CL-45] */
export const hasRestingTab = (): boolean => elsewhere.size > 0;

/** Whether this tab is to rest with a device, because another one is in front; while the calling scope lives. */
export function useFrontTab(deviceName: string): Readonly<ShallowRef<boolean>> {
  const isResting = shallowRef(false);
  const tab = new FrontTab({
    channel: new BroadcastChannel(`ubii.device.${deviceName}`),
    isVisible: () => document.visibilityState === 'visible',
    handleResting: (is) => (isResting.value = is),
    handleOther: (has) => void (has ? elsewhere.add(deviceName) : elsewhere.delete(deviceName)),
  });
  useEventListener(document, 'visibilitychange', () => tab.handleVisibility());
  const end = (): void => {
    elsewhere.delete(deviceName);
    tab.end();
  };
  // A page that is kept for the way back comes back as it was.
  useEventListener(window, 'pagehide', ({ persisted }: PageTransitionEvent) => {
    if (!persisted) end();
  });
  onScopeDispose(end);
  return isResting;
}
