import { useEventListener } from '@vueuse/core';
import type { Ref } from 'vue';
import type { CanvasStage } from './canvas-stage.ts';

/**
 * While Space is held, any pointer pans the canvas, also on nodes.
 * @param tap called when it is pressed and released without repeating and without a pointer meanwhile
 */
export function useSpacePan(
  host: Ref<HTMLElement | null>,
  stage: CanvasStage,
  tap: () => void,
): void {
  let isTap = false;
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
    isTap = !event.repeat && !(event.shiftKey || event.ctrlKey || event.altKey || event.metaKey);
    set(true);
  });
  useEventListener(window, 'keyup', (event) => {
    if (event.key !== ' ') return;
    if (isTap && stage.isPanning) tap();
    isTap = false;
    set(false);
  });
  useEventListener(window, ['pointerdown', 'wheel'], () => (isTap = false), {
    capture: true,
    passive: true,
  });
  useEventListener(window, 'blur', () => set(false));
}
