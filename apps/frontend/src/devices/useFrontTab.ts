import { useEventListener } from '@vueuse/core';
import { onScopeDispose, shallowReactive, shallowRef, type ShallowRef } from 'vue';
import { FrontTab } from './front-tab.ts';

/** Names of this page's devices that are inactive in another tab. */
const elsewhere = shallowReactive(new Set<string>());

/** Whether another tab of this browser is inactive because this one is in the foreground. [CL-45] */
export const hasRestingTab = (): boolean => elsewhere.size > 0;

/**
 * Whether this tab must be inactive for a device, because another one is in the foreground; while the calling scope is
 * active.
 */
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
  // A page in the back/forward cache is restored as it was.
  useEventListener(window, 'pagehide', ({ persisted }: PageTransitionEvent) => {
    if (!persisted) end();
  });
  onScopeDispose(end);
  return isResting;
}
