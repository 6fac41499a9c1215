import { useEventListener } from '@vueuse/core';
import { onBeforeUnmount, shallowRef, type ShallowRef } from 'vue';

/** Before the card of a row is shown, milliseconds; while one is shown, the next one comes at once. */
const DELAY_MS = 350;
/** To move the pointer onto the card, milliseconds. */
const GRACE_MS = 150;

/** The row whose preview is shown in full. */
export interface PreviewCard {
  /** Its element, with `data-preview`. */
  readonly row: Readonly<ShallowRef<HTMLElement | undefined>>;
  /** The pointer is on the card: it stays (WCAG 1.4.13). */
  stay(): void;
  leave(): void;
}

/** Shows the preview of the row under the mouse, or of the row that has the focus of the keyboard; Esc hides it. */
export function usePreviewCard(list: Readonly<ShallowRef<HTMLElement | null>>): PreviewCard {
  const row = shallowRef<HTMLElement>();
  let aimed: HTMLElement | undefined;
  let timer: ReturnType<typeof setTimeout> | undefined;

  function hide(): void {
    clearTimeout(timer);
    aimed = undefined;
    row.value = undefined;
  }
  function leave(): void {
    clearTimeout(timer);
    aimed = undefined;
    timer = setTimeout(hide, GRACE_MS);
  }
  function aim(next: HTMLElement | undefined): void {
    if (next === undefined) return leave();
    if (next === aimed) return;
    clearTimeout(timer);
    aimed = next;
    const show = (): void => void (row.value = next.isConnected ? next : undefined);
    if (row.value === undefined) timer = setTimeout(show, DELAY_MS);
    else show();
  }
  const rowOf = (target: EventTarget | null): HTMLElement | undefined =>
    target instanceof Element
      ? (target.closest<HTMLElement>('[data-preview]') ?? undefined)
      : undefined;

  useEventListener(list, 'pointerover', ({ target, pointerType }: PointerEvent) => {
    if (pointerType !== 'touch') aim(rowOf(target));
  });
  useEventListener(list, 'pointerleave', leave);
  useEventListener(list, 'focusin', ({ target }: FocusEvent) => {
    if (target instanceof Element && target.matches(':focus-visible')) aim(rowOf(target));
  });
  useEventListener(list, 'focusout', hide);
  useEventListener(list, 'scroll', hide, { capture: true, passive: true });
  useEventListener(document, 'pointerdown', hide);
  useEventListener(document, 'keydown', ({ key }: KeyboardEvent) => key === 'Escape' && hide());
  onBeforeUnmount(hide);
  return { row, stay: () => clearTimeout(timer), leave };
}
