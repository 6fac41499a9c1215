import { useControls } from './useControls.ts';
import { usePadPointer } from './usePadPointer.ts';

/** Listeners of a button that is played with. */
export function usePressPad() {
  const { press } = useControls();
  const pointer = usePadPointer({
    down: () => press('pad', true),
    up: () => press('pad', false),
  });
  return {
    ...pointer,
    /** Screen readers and switches click without a pointer; the button is down for one frame. */
    click: (event: MouseEvent) => {
      if (event.detail !== 0) return;
      press('pad', true);
      requestAnimationFrame(() => press('pad', false));
    },
  };
}
