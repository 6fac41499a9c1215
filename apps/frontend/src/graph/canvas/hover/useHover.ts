import { isSameValue } from '@ubii/proto';
import { useEventListener } from '@vueuse/core';
import { onScopeDispose, shallowRef, type ShallowRef } from 'vue';
import { hoverTarget, type HoverTarget } from './hover-target.ts';

/** Time a pointer must rest before values are requested, milliseconds. */
const REST_MS = 300;
/** Time without a hover card after a press, so that it does not cover wires being drawn, milliseconds. */
const CALM_MS = 1200;

/** Hovered element, and its position on the page. */
export interface Hovered {
  readonly target: HoverTarget;
  readonly clientX: number;
  readonly clientY: number;
  /** Reached by keyboard: the card is shown below its node. */
  readonly isBelow: boolean;
  /** Right edge of the node, on the page. */
  readonly right: number;
}

/** Tracks the element that the pointer rests on or the keyboard has reached. Touch uses the context menu instead. */
export function useHover(container: HTMLElement): Readonly<ShallowRef<Hovered | undefined>> {
  const hovered = shallowRef<Hovered>();
  let next: HoverTarget | undefined;
  let timer: ReturnType<typeof setTimeout> | undefined;
  /** A pressed element shows no card until the pointer has left it. */
  let pressed: HoverTarget | undefined;
  let calmUntil = 0;

  function hide(): void {
    clearTimeout(timer);
    next = undefined;
    hovered.value = undefined;
  }
  function wait(
    target: HoverTarget,
    at: { x: number; y: number; right?: number },
    ms: number,
    isBelow = false,
  ): void {
    hide();
    next = target;
    timer = setTimeout(() => {
      hovered.value = { target, clientX: at.x, clientY: at.y, isBelow, right: at.right ?? at.x };
    }, ms);
  }

  useEventListener(container, 'pointerover', (event) => {
    if (event.pointerType === 'touch' || event.buttons !== 0) return;
    const target = hoverTarget(event.target as Element);
    if (!isSameValue(target, pressed)) pressed = undefined;
    if (target === undefined || pressed !== undefined) hide();
    else if (!isSameValue(target, next))
      wait(target, event, Math.max(REST_MS, calmUntil - event.timeStamp));
  });
  useEventListener(container, 'pointerleave', hide);
  useEventListener(container, 'wheel', hide, { passive: true });
  useEventListener(container, 'pointerdown', hide, { capture: true });
  useEventListener(
    window,
    'pointerup',
    ({ target, timeStamp }) => {
      pressed = hoverTarget(target instanceof Element ? target : null);
      calmUntil = timeStamp + CALM_MS;
    },
    { capture: true },
  );
  useEventListener(container, 'focusin', (event) => {
    const element = event.target as Element;
    if (!element.matches('[data-port]:focus-visible')) return;
    const node = element.closest('[data-graph-node]') ?? element;
    const { left, bottom, right } = node.getBoundingClientRect();
    const target = hoverTarget(element);
    if (target) wait(target, { x: left, y: bottom, right }, REST_MS, true);
  });
  useEventListener(container, 'focusout', hide);
  useEventListener(container, 'keydown', (event) => event.key === 'Escape' && hide());
  onScopeDispose(hide);
  return hovered;
}
