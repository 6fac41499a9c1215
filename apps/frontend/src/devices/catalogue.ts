import { Camera, Gamepad2, Joystick, Keyboard, Smartphone } from '@lucide/vue';
import type { Component } from 'vue';

/** Page on which this browser is a device. */
export interface DevicePage {
  readonly path: string;
  readonly title: string;
  readonly icon: Component;
  /** Data that it provides, a few words. */
  readonly summary: string;
  /** Data that it publishes and receives, one or two sentences. */
  readonly description: string;
  readonly page: () => Promise<unknown>;
}

export const DEVICE_PAGES: readonly DevicePage[] = [
  {
    path: '/devices/smart-device',
    title: 'Smart device',
    icon: Smartphone,
    summary: 'Touch, motion, compass, buttons',
    description:
      'Publishes touch, motion, orientation, compass, buttons, text and, if you allow it, microphone level and location. Vibrates, plays tones, lights up and shows what it receives.',
    page: () => import('./smart-device/SmartDevicePage.vue'),
  },
  {
    path: '/devices/controller',
    title: 'Controller',
    icon: Joystick,
    summary: 'Stick, buttons and tilt for games',
    description:
      'Publishes a stick, the buttons A, B and Start, orientation and acceleration. Shows colours and pictures and vibrates. A session can switch it between gamepad and camera.',
    page: () => import('./controller/ControllerPage.vue'),
  },
  {
    path: '/devices/camera',
    title: 'Camera',
    icon: Camera,
    summary: 'Camera pictures for sessions',
    description:
      'Publishes camera pictures in the size and rate that you choose, and draws the objects that sessions detect in them.',
    page: () => import('./camera/CameraPage.vue'),
  },
  {
    path: '/devices/gamepad',
    title: 'Gamepad',
    icon: Gamepad2,
    summary: 'A gamepad that is plugged in or paired',
    description:
      'Publishes the sticks, triggers and buttons of connected gamepads, with rumble as output.',
    page: () => import('./gamepad/GamepadPage.vue'),
  },
  {
    path: '/devices/keyboard-mouse',
    title: 'Keyboard and mouse',
    icon: Keyboard,
    summary: 'Keys and a pad for the pointer',
    description:
      'Publishes keys and the mouse position on a pad. Publishes nothing while the pad is not in use.',
    page: () => import('./keyboard-mouse/KeyboardMousePage.vue'),
  },
];
