import {
  ButtonEventType,
  type Color,
  FAREWELL_TOPIC,
  type Image2D,
  type Vector2,
  type Vector3,
} from '@ubii/proto';
import { useEventListener } from '@vueuse/core';
import { onScopeDispose, shallowReactive, shallowRef } from 'vue';
import { useConnection } from '../../connection/useConnection.ts';
import { canVibrate, vibrate } from '../outputs/vibrate.ts';
import { calibratedAngles, type EulerAngles } from '../sensors/orientation.ts';
import { useMotionSensors } from '../sensors/useMotionSensors.ts';
import { useDevice } from '../useDevice.ts';
import { CONTROLLER_GAMEPAD_DEVICE, controllerGamepadComponents } from './components.ts';

/** Keys of the events that existing programs expect. */
const KEYS = { button_a: '1', button_b: '2', button_start: 'start' } as const;
export type ControllerButton = keyof typeof KEYS;

/** The controller's gamepad: publishes its controls, performs the outputs of a session. */
export function useVirtualGamepad() {
  const { client } = useConnection();
  const outputs = shallowReactive({
    color: undefined as Color | undefined,
    image: undefined as Image2D | undefined,
    isVibrating: false,
  });
  let vibrationTimer: ReturnType<typeof setTimeout> | undefined;

  const device = useDevice({
    name: CONTROLLER_GAMEPAD_DEVICE,
    tags: ['gamepad', 'controller', 'web interface'],
    components: controllerGamepadComponents(),
    receivers: {
      set_color: (color) => (outputs.color = color.a > 0 ? color : undefined),
      set_image: (image) => (outputs.image = image.data.length > 0 ? image : undefined),
      clear_image: () => (outputs.image = undefined),
      ...(canVibrate()
        ? {
            vibration_pattern: (durationMs: number) => {
              // Also shown, because the vibration of a phone on a table is not felt.
              outputs.isVibrating = durationMs > 0;
              clearTimeout(vibrationTimer);
              vibrationTimer = setTimeout(
                () => (outputs.isVibrating = false),
                Math.min(Math.max(durationMs, 120), 5000),
              );
              vibrate(durationMs);
            },
          }
        : {}),
    },
  });

  let angles: EulerAngles | undefined;
  let zero: EulerAngles | undefined;
  const isCalibrated = shallowRef(false);
  const hasMotion = shallowRef(false);
  const motion = useMotionSensors({
    motion({ acceleration }) {
      if (acceleration?.x == null || acceleration.y == null || acceleration.z == null) return;
      const { x, y, z } = acceleration;
      hasMotion.value = true;
      device.publish('linear_acceleration', { x, y, z } satisfies Vector3);
    },
    orientation({ alpha, beta, gamma }) {
      angles = { alpha: alpha ?? 0, beta: beta ?? 0, gamma: gamma ?? 0 };
      hasMotion.value = true;
      device.publish('orientation', calibratedAngles(angles, zero));
    },
    compass: () => undefined,
  });

  // Tells games that the player left, before they notice the lost connection.
  const sayFarewell = (): void =>
    client.publish(FAREWELL_TOPIC, 'string', client.id, { immediate: true });
  useEventListener(window, 'pagehide', sayFarewell);
  onScopeDispose(() => {
    clearTimeout(vibrationTimer);
    sayFarewell();
  });

  return {
    outputs,
    motion,
    hasMotion,
    isCalibrated,
    /** Sets the current orientation as zero; again: resets it. */
    calibrate(): void {
      zero = zero ? undefined : angles;
      isCalibrated.value = zero !== undefined;
    },
    stick: (at: Vector2) =>
      device.publish('analog_stick_left', at, { immediate: at.x === 0 && at.y === 0 }),
    press(button: ControllerButton, isDown: boolean): void {
      const type = isDown ? ButtonEventType.DOWN : ButtonEventType.UP;
      device.publish(button, { type, key: KEYS[button] }, { immediate: true });
      if (isDown) vibrate(10);
    },
  };
}
