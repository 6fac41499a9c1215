import { ButtonEventType, type Vector2 } from '@ubii/proto';
import { useEventListener } from '@vueuse/core';
import { onScopeDispose, shallowReactive } from 'vue';
import { stickOfKeys } from '../controls/stick.ts';
import { useDevice } from '../useDevice.ts';
import { KEYBOARD_MOUSE_COMPONENTS, KEYBOARD_MOUSE_DEVICE } from './components.ts';
import { HeldKeys, isCaptured } from './held-keys.ts';

/** `MouseEvent.button` of each bit in `MouseEvent.buttons`. */
const BUTTON_BITS = [0, 2, 1, 3, 4];
const MIDDLE: Vector2 = { x: 0, y: 0 };

/** Keyboard and mouse as a device, while a pad has the focus or the mouse is on it. */
export function useKeyboardMouse(pad: () => HTMLElement | null) {
  const shown = shallowReactive({
    keys: [] as readonly string[],
    buttons: [] as readonly number[],
    stick: MIDDLE,
    at: undefined as Vector2 | undefined,
    wheel: MIDDLE,
    isFocused: false,
    isLocked: false,
  });
  const device = useDevice({
    name: KEYBOARD_MOUSE_DEVICE,
    tags: ['keyboard', 'mouse', 'web interface'],
    components: KEYBOARD_MOUSE_COMPONENTS,
  });
  const keys = new HeldKeys();
  const buttons = new Set<number>();
  const typeOf = (isDown: boolean) => (isDown ? ButtonEventType.DOWN : ButtonEventType.UP);

  function tellKey(key: string, isDown: boolean): void {
    device.publish('button', { type: typeOf(isDown), key }, { immediate: true });
    shown.keys = keys.names;
    const stick = stickOfKeys(keys.codes);
    if (stick.x === shown.stick.x && stick.y === shown.stick.y) return;
    shown.stick = stick;
    device.publish('analog_stick_left', stick, { immediate: true });
  }

  function tellButton(button: number, isDown: boolean): void {
    if (buttons.has(button) === isDown) return;
    if (isDown) buttons.add(button);
    else buttons.delete(button);
    shown.buttons = [...buttons];
    device.publish('mouse_button', { type: typeOf(isDown), button }, { immediate: true });
  }

  function letGo(): void {
    for (const key of keys.releaseAll()) tellKey(key, false);
    for (const button of [...buttons]) tellButton(button, false);
  }

  function lock(): void {
    // Rejected without a mouse; some browsers return no promise.
    const answer = pad()?.requestPointerLock() as Promise<void> | undefined;
    answer?.catch(() => undefined);
  }
  useEventListener(document, 'pointerlockchange', () => {
    shown.isLocked = document.pointerLockElement !== null && document.pointerLockElement === pad();
    if (!shown.isLocked) letGo();
  });
  useEventListener(window, 'blur', letGo);
  useEventListener(document, 'visibilitychange', () => {
    if (document.visibilityState === 'hidden') letGo();
  });
  onScopeDispose(letGo);

  return {
    shown,
    lock,
    focus(isFocused: boolean): void {
      shown.isFocused = isFocused;
      if (!isFocused) letGo();
    },
    keyDown(event: KeyboardEvent): void {
      if (!isCaptured(event)) return;
      event.preventDefault();
      if (keys.press(event.code, event.key)) tellKey(event.key, true);
    },
    keyUp(event: KeyboardEvent): void {
      // With any modifier: every pressed key must be released.
      const key = keys.release(event.code);
      if (key === undefined) return;
      event.preventDefault();
      tellKey(key, false);
    },
    /** The pointer was pressed, moved or released. */
    point(event: PointerEvent): void {
      const element = pad();
      if (!element) return;
      // Take the state of all buttons from the event, in case one was missed.
      BUTTON_BITS.forEach((button, bit) => tellButton(button, (event.buttons & (1 << bit)) !== 0));
      if (event.type === 'pointerdown') element.setPointerCapture(event.pointerId);
      if (shown.isLocked) {
        const { movementX: x, movementY: y } = event;
        if (x !== 0 || y !== 0) device.publish('mouse_movement', { x, y });
        return;
      }
      const box = element.getBoundingClientRect();
      const within = (value: number): number => Math.min(1, Math.max(0, value));
      shown.at = {
        x: within((event.clientX - box.left) / box.width),
        y: within((event.clientY - box.top) / box.height),
      };
      device.publish('touch_position', shown.at);
    },
    letGo,
    wheel(event: WheelEvent): void {
      // Converts lines and pages to pixels, for browsers that report those.
      const unit = [1, 16, 400][event.deltaMode] ?? 1;
      shown.wheel = { x: event.deltaX * unit, y: event.deltaY * unit };
      device.publish('mouse_wheel', shown.wheel);
    },
  };
}
