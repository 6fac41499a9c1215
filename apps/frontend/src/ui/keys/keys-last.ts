import { useEventListener } from '@vueuse/core';
import { shallowRef, type ShallowRef } from 'vue';
import { takesKeys } from './single-key.ts';

/** Held while a pointer works, too. */
const MODIFIERS: ReadonlySet<string> = new Set(['Alt', 'Control', 'Meta', 'Shift']);

/**
 * Whether the user pressed a key after the last press of a pointer. Keys in fields and lists do not count:
 * those who use a pointer type there, too.
 */
export function useKeysLast(): Readonly<ShallowRef<boolean>> {
  const isKeys = shallowRef(false);
  useEventListener(
    window,
    'keydown',
    ({ key, target }: KeyboardEvent) => {
      if (!MODIFIERS.has(key) && !takesKeys(target)) isKeys.value = true;
    },
    { capture: true },
  );
  useEventListener(window, 'pointerdown', () => (isKeys.value = false), { capture: true });
  return isKeys;
}
