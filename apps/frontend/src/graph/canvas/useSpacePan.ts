import { useEventListener } from '@vueuse/core';
import type { Ref } from 'vue';
import type { CanvasStage } from './canvas-stage.ts';

/** While Space is held, any pointer pans the canvas, also on nodes. */
export function useSpacePan(host: Ref<HTMLElement | null>, stage: CanvasStage): void {
  function set(isPanning: boolean): void {
    stage.isPanning = isPanning;
    stage.container.classList.toggle('panning', isPanning);
  }
  useEventListener(host, 'keydown', (event: KeyboardEvent) => {
    const target = event.target as HTMLElement;
    const isOnCanvas = target === host.value || stage.container.contains(target);
    // Space keeps its meaning on buttons and in fields.
    if (event.key !== ' ' || !isOnCanvas || target.closest('button, input, textarea, select'))
      return;
    event.preventDefault();
    set(true);
  });
  useEventListener(window, 'keyup', (event) => {
    if (event.key === ' ') set(false);
  });
  useEventListener(window, 'blur', () => set(false));
}
