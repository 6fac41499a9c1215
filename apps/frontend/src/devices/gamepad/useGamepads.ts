import { useEventListener, useRafFn } from '@vueuse/core';
import { shallowRef } from 'vue';

/**
 * The pads of this computer. Browsers show none until a button was pressed while the page is in front,
 * and have no events for what pads say: they are looked at once a frame.
 */
export function useGamepads() {
  const isSupported = 'getGamepads' in navigator;
  /** Places of those that are there, as browsers number them; 0 to 3. */
  const indices = shallowRef<readonly number[]>([]);
  const listeners = new Map<number, (pad: Gamepad | undefined) => void>();

  function look(): void {
    if (!isSupported) return;
    const pads = navigator.getGamepads().filter((pad) => pad?.connected);
    const found = pads.map((pad) => pad!.index);
    if (found.join() !== indices.value.join()) indices.value = found;
    for (const pad of pads) listeners.get(pad!.index)?.(pad!);
  }
  useRafFn(look);
  // A hidden page has no frames: release all buttons.
  const letGo = (): void => listeners.forEach((listener) => listener(undefined));
  useEventListener(document, 'visibilitychange', () => {
    if (document.visibilityState === 'hidden') letGo();
  });

  return {
    isSupported,
    indices,
    /** @param listener is told the pad once a frame, and nothing when the page is left */
    listen(index: number, listener: (pad: Gamepad | undefined) => void): () => void {
      listeners.set(index, listener);
      return () => listeners.delete(index);
    },
  };
}

export type Gamepads = ReturnType<typeof useGamepads>;
