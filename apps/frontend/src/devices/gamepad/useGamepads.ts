import { useEventListener, useRafFn } from '@vueuse/core';
import { shallowRef } from 'vue';

/**
 * Gamepads of this computer. Browsers report one after a button was pressed while the page has the focus, and have no
 * events for their state: it is polled once per frame.
 */
export function useGamepads() {
  const isSupported = 'getGamepads' in navigator;
  /** Indices of connected pads, as numbered by the browser; 0 to 3. */
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
    /** @param listener called once per frame with the pad; with undefined when the page is hidden */
    listen(index: number, listener: (pad: Gamepad | undefined) => void): () => void {
      listeners.set(index, listener);
      return () => listeners.delete(index);
    },
  };
}

export type Gamepads = ReturnType<typeof useGamepads>;
