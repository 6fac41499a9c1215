import { useEventListener } from '@vueuse/core';
import { shallowRef, type ShallowRef } from 'vue';
import { takesKeys } from './single-key.ts';

/** Modifier keys do not count, because they are also held while using a pointer. */
const MODIFIERS: ReadonlySet<string> = new Set(['Alt', 'Control', 'Meta', 'Shift']);

/**
 * Whether the user pressed a key after the last pointer press. Keys in fields and lists do not count, because pointer
 * users type there, too.
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
