import { Camera, Gamepad2, Joystick, Keyboard, Smartphone } from '@lucide/vue';
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
  {
    path: '/devices/controller',
    title: 'Controller',
    icon: Joystick,
    description:
      'Stick, A, B, Start, orientation and acceleration for games. It shows colours and pictures and vibrates; a session makes it a camera and a gamepad again.',
    page: () => import('./controller/ControllerPage.vue'),
  },
  {
    path: '/devices/camera',
    title: 'Camera',
    icon: Camera,
    description:
      'Pictures of the camera, as large and as often as you choose, with what sessions find in them drawn over.',
    page: () => import('./camera/CameraPage.vue'),
  },
  {
    path: '/devices/gamepad',
    title: 'Gamepad',
    icon: Gamepad2,
    description:
      'Gamepads at this device: sticks, triggers and buttons under the names of the controller, and rumble.',
    page: () => import('./gamepad/GamepadPage.vue'),
  },
  {
    path: '/devices/keyboard-mouse',
    title: 'Keyboard and mouse',
    icon: Keyboard,
    description:
      'Keys and the mouse on a pad, in place of a phone or a controller. Nothing is sent while the pad is not in use.',
    page: () => import('./keyboard-mouse/KeyboardMousePage.vue'),
  },
];
