import { useEventListener } from '@vueuse/core';
import { onScopeDispose, shallowRef } from 'vue';
import { watchBattery, type BatteryState } from '../../connection/battery.ts';

/** What the browser tells of the device itself: its battery, and whether the page is seen. */
export function useDeviceHealth(handlers: {
  battery(level: number): void;
  visible(isVisible: boolean): void;
}) {
  const battery = shallowRef<BatteryState>();
  const tellVisible = (): void => handlers.visible(document.visibilityState === 'visible');
  const stop = watchBattery((state) => {
    battery.value = state;
    handlers.battery(state.level);
  });
  onScopeDispose(stop);
  useEventListener(document, 'visibilitychange', tellVisible);
  return {
    battery,
    /** Says all of it again: to a master that does not know it. */
    tell(): void {
      if (battery.value) handlers.battery(battery.value.level);
      tellVisible();
    },
  };
}
