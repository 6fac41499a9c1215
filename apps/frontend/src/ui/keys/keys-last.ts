import { useEventListener } from '@vueuse/core';
import { shallowRef, type ShallowRef } from 'vue';

/** Held while a pointer works, too. */
const MODIFIERS: ReadonlySet<string> = new Set(['Alt', 'Control', 'Meta', 'Shift']);

/** Whether the user pressed a key after the last press of a pointer. */
export function useKeysLast(): Readonly<ShallowRef<boolean>> {
  const isKeys = shallowRef(false);
  useEventListener(
    window,
    'keydown',
    ({ key }: KeyboardEvent) => {
      if (!MODIFIERS.has(key)) isKeys.value = true;
    },
    { capture: true },
  );
  useEventListener(window, 'pointerdown', () => (isKeys.value = false), { capture: true });
  return isKeys;
}
