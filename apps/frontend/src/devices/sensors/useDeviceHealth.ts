import { useEventListener } from '@vueuse/core';
import { onScopeDispose, shallowRef } from 'vue';
import { watchBattery, type BatteryState } from '../../connection/battery.ts';

/** State of the device: its battery, and the visibility of the page. */
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
    /** Reports all values again, for a master that does not know them. */
    tell(): void {
      if (battery.value) handlers.battery(battery.value.level);
      tellVisible();
    },
  };
}
