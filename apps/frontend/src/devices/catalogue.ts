import { Smartphone } from '@lucide/vue';
import type { Component } from 'vue';

/** A way in which this browser can be a device. */
export interface DevicePage {
  readonly path: string;
  readonly title: string;
  readonly icon: Component;
  /** What it gives and takes, one sentence. */
  readonly description: string;
  readonly page: () => Promise<unknown>;
}

export const DEVICE_PAGES: readonly DevicePage[] = [
  {
    path: '/devices/smart-device',
    title: 'Smart device',
    icon: Smartphone,
    description:
      'Touch, motion, orientation, compass, buttons, text and, if you allow it, microphone level and location. It vibrates, sounds, lights up and shows what it is sent.',
    page: () => import('./smart-device/SmartDevicePage.vue'),
  },
];
