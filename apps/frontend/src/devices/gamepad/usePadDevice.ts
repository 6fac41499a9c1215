import { ButtonEventType } from '@ubii/proto';
import { onScopeDispose, shallowRef } from 'vue';
import { useDevice } from '../useDevice.ts';
import { GAMEPAD_COMPONENTS, GAMEPAD_DEVICE } from './components.ts';
import { padChanges, readPad, RESTING, type PadState } from './read-pad.ts';
import type { Gamepads } from './useGamepads.ts';

const LONGEST_RUMBLE_MS = 5000;

/** A pad as a separate device, while the calling scope is active. */
export function usePadDevice(pads: Gamepads, index: number) {
  const state = shallowRef<PadState>(RESTING);
  const name = shallowRef('Gamepad');
  const isStandard = shallowRef(true);
  const canRumble = shallowRef(false);
  const rumbledAtMs = shallowRef<number>();
  let pad: Gamepad | undefined;

  const device = useDevice({
    name: index === 0 ? GAMEPAD_DEVICE : `${GAMEPAD_DEVICE}-${index + 1}`,
    tags: ['gamepad', 'controller', 'web interface'],
    components: GAMEPAD_COMPONENTS,
    receivers: {
      vibration_pattern(durationMs) {
        rumbledAtMs.value = Date.now();
        rumble(durationMs);
      },
    },
  });

  function rumble(durationMs: number): void {
    const duration = Math.min(Math.max(durationMs, 0), LONGEST_RUMBLE_MS);
    pad?.vibrationActuator
      ?.playEffect('dual-rumble', { duration, strongMagnitude: 1, weakMagnitude: 0.6 })
      // Fails for gamepads without motors, and before any user interaction.
      .catch(() => undefined);
  }

  function become(next: PadState): void {
    const { left, right, leftTrigger, rightTrigger, buttons } = padChanges(state.value, next);
    if (left) device.publish('analog_stick_left', left);
    if (right) device.publish('analog_stick_right', right);
    if (leftTrigger !== undefined) device.publish('trigger_left', leftTrigger);
    if (rightTrigger !== undefined) device.publish('trigger_right', rightTrigger);
    for (const { name: button, key, isDown } of buttons) {
      const type = isDown ? ButtonEventType.DOWN : ButtonEventType.UP;
      device.publish(button, { type, key }, { immediate: true });
    }
    if (left || right || buttons.length > 0 || (leftTrigger ?? rightTrigger) !== undefined) {
      state.value = next;
    }
  }

  const stop = pads.listen(index, (now) => {
    pad = now;
    if (now) {
      name.value = now.id;
      isStandard.value = now.mapping === 'standard';
      canRumble.value = Boolean(now.vibrationActuator as unknown);
    }
    // Before the device is registered, changes would be lost and missing later.
    if (device.isRegistered.value) become(now ? readPad(now) : RESTING);
  });
  onScopeDispose(() => {
    stop();
    become(RESTING);
  });

  return { state, name, isStandard, canRumble, rumbledAtMs, test: () => rumble(300) };
}
