import { watch } from 'vue';

import type { PagePoint } from './stick.ts';
import { useControls } from './useControls.ts';

interface PadHandlers {
  down(point: PagePoint): void;
  move?(point: PagePoint): void;
  up(): void;
}

/** The first finger on a pad, from down to up wherever it goes. Each pad has its own: two thumbs do not meet. */
export function usePadPointer({ down, move, up }: PadHandlers) {
  const { releases } = useControls();
  let pointer: number | undefined;
  const isMine = (event: PointerEvent): boolean => event.pointerId === pointer;
  const end = (event: PointerEvent): void => {
    if (!isMine(event)) return;
    pointer = undefined;
    up();
  };
  watch(
    releases,
    () => {
      if (pointer === undefined) return;
      pointer = undefined;
      up();
    },
    { flush: 'sync' },
  );
  return {
    pointerdown: (event: PointerEvent) => {
      if (pointer !== undefined || event.button > 0) return;
      pointer = event.pointerId;
      (event.currentTarget as Element).setPointerCapture?.(event.pointerId);
      down({ x: event.clientX, y: event.clientY });
    },
    pointermove: (event: PointerEvent) => {
      if (isMine(event)) move?.({ x: event.clientX, y: event.clientY });
    },
    pointerup: end,
    pointercancel: end,
    lostpointercapture: end,
    contextmenu: (event: Event) => event.preventDefault(),
  };
}

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
