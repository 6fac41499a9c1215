import { useEventListener } from '@vueuse/core';
import { onScopeDispose, shallowRef, type ShallowRef } from 'vue';
import { hoverTarget, isSameTarget, type HoverTarget } from './hover-target.ts';

/** How long a pointer rests before values are asked for, milliseconds. */
const REST_MS = 300;
/** How long a finger is held down, and how far it may stray, pixels. */
const HOLD_MS = 500;
const STRAY_PX = 8;

/** What is pointed at, and where on the page. */
export interface Hovered {
  readonly target: HoverTarget;
  readonly clientX: number;
  readonly clientY: number;
}

/** Follows what a pointer rests on, a finger holds, or the keyboard has reached on the canvas. */
export function useHover(container: HTMLElement): Readonly<ShallowRef<Hovered | undefined>> {
  const hovered = shallowRef<Hovered>();
  let next: HoverTarget | undefined;
  let timer: ReturnType<typeof setTimeout> | undefined;

  function hide(): void {
    clearTimeout(timer);
    next = undefined;
    hovered.value = undefined;
  }
  function wait(target: HoverTarget, at: { x: number; y: number }, ms: number): void {
    hide();
    next = target;
    timer = setTimeout(() => {
      hovered.value = { target, clientX: at.x, clientY: at.y };
    }, ms);
  }

  useEventListener(container, 'pointerover', (event) => {
    if (event.pointerType === 'touch' || event.buttons !== 0) return;
    const target = hoverTarget(event.target as Element);
    if (target === undefined) hide();
    else if (!isSameTarget(target, next)) wait(target, event, REST_MS);
  });
  useEventListener(container, 'pointerleave', hide);
  useEventListener(container, 'wheel', hide, { passive: true });
  let start = { x: 0, y: 0 };
  useEventListener(
    container,
    'pointerdown',
    (event) => {
      hide();
      start = { x: event.clientX, y: event.clientY };
      const chip = (event.target as Element).closest('[data-wire-chip], [data-port]');
      const target = event.pointerType === 'touch' ? hoverTarget(chip) : undefined;
      if (target) wait(target, start, HOLD_MS);
    },
    { capture: true },
  );
  useEventListener(container, 'pointermove', (event) => {
    const far = Math.hypot(event.clientX - start.x, event.clientY - start.y) > STRAY_PX;
    if (event.pointerType === 'touch' && far) hide();
  });
  useEventListener(container, 'pointerup', (event) => {
    // What a finger has brought up stays until the next touch.
    if (event.pointerType === 'touch' && hovered.value === undefined) hide();
  });
  useEventListener(container, 'focusin', (event) => {
    const element = event.target as Element;
    if (!element.matches('[data-port]:focus-visible')) return;
    const { right, bottom } = element.getBoundingClientRect();
    const target = hoverTarget(element);
    if (target) wait(target, { x: right, y: bottom }, REST_MS);
  });
  useEventListener(container, 'focusout', hide);
  useEventListener(container, 'keydown', (event) => event.key === 'Escape' && hide());
  onScopeDispose(hide);
  return hovered;
}
