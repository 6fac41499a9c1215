import { shallowRef, type ShallowRef } from 'vue';
import { sideAt } from './layout/layout-rects.ts';
import type { Side } from './layout/layout.ts';

/** Drop position of a dragged panel. */
export interface PanelDrop {
  readonly id: string;
  readonly side: Side;
}

/** Drags panels by their handles, with mouse, pen or finger. Escape cancels. */
export function usePanelDrag(move: (id: string, drop: PanelDrop) => void): {
  readonly dragged: Readonly<ShallowRef<string | undefined>>;
  readonly drop: Readonly<ShallowRef<PanelDrop | undefined>>;
  grab(id: string, event: PointerEvent): void;
} {
  const dragged = shallowRef<string>();
  const drop = shallowRef<PanelDrop>();

  function dropAt(id: string, { clientX, clientY }: PointerEvent): PanelDrop | undefined {
    const under = document.elementFromPoint(clientX, clientY)?.closest<HTMLElement>('[data-panel]');
    const target = under?.dataset['panel'];
    if (!under || target === undefined || target === id) return undefined;
    const { left, top, width, height } = under.getBoundingClientRect();
    return { id: target, side: sideAt((clientX - left) / width, (clientY - top) / height) };
  }

  function grab(id: string, event: PointerEvent): void {
    if (event.button !== 0) return;
    event.preventDefault();
    const grip = event.currentTarget instanceof HTMLElement ? event.currentTarget : undefined;
    grip?.setPointerCapture(event.pointerId);
    const end = new AbortController();
    const { signal } = end;
    const finish = (): void => {
      end.abort();
      dragged.value = undefined;
      drop.value = undefined;
    };
    const follow = (next: PointerEvent): void => {
      dragged.value = id;
      drop.value = dropAt(id, next);
    };
    window.addEventListener('pointermove', follow, { signal });
    window.addEventListener(
      'pointerup',
      () => {
        const landed = drop.value;
        finish();
        if (landed) move(id, landed);
      },
      { signal },
    );
    window.addEventListener('pointercancel', finish, { signal });
    window.addEventListener('keydown', (key) => key.key === 'Escape' && finish(), { signal });
  }

  return { dragged, drop, grab };
}
