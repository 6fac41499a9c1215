import { useEventListener } from '@vueuse/core';
import { shallowRef } from 'vue';

/** Chromium's battery; others tell nothing, to keep people from being recognised by it. */
interface Battery extends EventTarget {
  /** 0 to 1. */
  readonly level: number;
  readonly charging: boolean;
}

/** What the browser tells of the device itself: its battery, and whether the page is seen. */
export function useDeviceHealth(handlers: {
  battery(level: number): void;
  visible(isVisible: boolean): void;
}) {
  const battery = shallowRef<{ readonly level: number; readonly isCharging: boolean }>();
  const { getBattery } = navigator as { getBattery?: () => Promise<Battery> };
  void getBattery?.call(navigator).then(
    (source) => {
      const read = (): void => {
        battery.value = { level: source.level, isCharging: source.charging };
        handlers.battery(source.level);
      };
      read();
      useEventListener(source, ['levelchange', 'chargingchange'], read);
    },
    () => undefined,
  );
  useEventListener(document, 'visibilitychange', () =>
    handlers.visible(document.visibilityState === 'visible'),
  );
  return { battery };
}
