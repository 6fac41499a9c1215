import type { RegisteredDevice } from '@ubii/client-web';
import { ButtonEventType } from '@ubii/proto';
import { useEventListener } from '@vueuse/core';
import { watch, type Ref } from 'vue';
import { useConnection } from '../../../connection/useConnection.ts';
import { HeldKeys, isCaptured } from '../../../devices/keyboard-mouse/held-keys.ts';
import { PAGE_COMPONENTS, PAGE_DEVICE } from './page-device.ts';

/** Text that the user types into a field is not published. */
function isTyping(target: EventTarget | null): boolean {
  return (
    target instanceof HTMLElement &&
    (target.isContentEditable || /^(INPUT|TEXTAREA|SELECT)$/.test(target.tagName))
  );
}

/** Publishes clicks and keys of this page as a device, while `isOn`; keys only while `takesKeys`. */
export function usePageDevice(isOn: Ref<boolean>, takesKeys: Ref<boolean>): void {
  const { client } = useConnection();
  const keys = new HeldKeys();
  let device: RegisteredDevice<typeof PAGE_COMPONENTS> | undefined;

  watch(
    isOn,
    async (on, _before, onCleanup) => {
      if (!on) return;
      let isOver = false;
      onCleanup(() => {
        isOver = true;
        void device?.close();
        device = undefined;
      });
      try {
        const registered = await client.registerDevice({
          name: PAGE_DEVICE,
          tags: ['example'],
          components: PAGE_COMPONENTS,
        });
        if (isOver) return void registered.close();
        device = registered;
        // Publish initial values, so that a session has a value when it starts.
        registered.component('is_pressed').publish(false);
        registered.component('escape').publish(false);
      } catch {
        // The client is closed or has no right to register devices; the shell shows the error.
      }
    },
    { immediate: true },
  );

  function publishKey(type: ButtonEventType, key: string): void {
    device?.component('button').publish({ type, key });
  }
  function releaseAll(): void {
    for (const key of keys.releaseAll()) publishKey(ButtonEventType.UP, key);
  }
  const options = { passive: true, capture: true };
  useEventListener(
    window,
    ['pointerdown', 'pointerup', 'pointercancel'],
    ({ type, isPrimary }: PointerEvent) => {
      if (isPrimary) device?.component('is_pressed').publish(type === 'pointerdown');
    },
    options,
  );
  useEventListener(
    window,
    ['keydown', 'keyup'],
    (event: KeyboardEvent) => {
      const isDown = event.type === 'keydown';
      if (event.key === 'Escape' && !event.repeat) device?.component('escape').publish(isDown);
      if (!isDown) {
        const key = keys.release(event.code);
        if (key !== undefined) publishKey(ButtonEventType.UP, key);
      } else if (takesKeys.value && isCaptured(event) && !isTyping(event.target)) {
        // Prevent single-key shortcuts: letters are input of the session.
        if (event.key.length === 1 && event.key !== ' ') event.preventDefault();
        if (keys.press(event.code, event.key)) publishKey(ButtonEventType.DOWN, event.key);
      }
    },
    { capture: true },
  );
  useEventListener(window, 'blur', releaseAll);
  watch(takesKeys, (takes) => takes || releaseAll());
}
