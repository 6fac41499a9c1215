import { useEventListener } from '@vueuse/core';
import { onUpdated, type Ref } from 'vue';

/**
 * Keeps the focus of the keyboard among the buttons of an element: when the button that has it
 * disappears, the button that takes its place gets the focus. Call it in the component that renders them.
 */
export function useKeptFocus(host: Readonly<Ref<HTMLElement | null>>): void {
  const buttons = (): HTMLElement[] => [...(host.value?.querySelectorAll('button') ?? [])];
  /** The button that has or had the focus, and its place among the others. */
  let last: { readonly element: HTMLElement; readonly index: number } | undefined;

  useEventListener(document, 'focusin', ({ target }: FocusEvent) => {
    const index = buttons().indexOf(target as HTMLElement);
    last = index === -1 ? undefined : { element: target as HTMLElement, index };
  });
  // A press elsewhere takes the focus, also where nothing can have it.
  useEventListener(document, 'pointerdown', ({ target }: PointerEvent) => {
    if (host.value?.contains(target as Node) !== true) last = undefined;
  });
  onUpdated(() => {
    if (last === undefined || last.element.isConnected) return;
    if (document.activeElement !== document.body) return;
    const now = buttons();
    // With none left yet, such as while a session stops, the next one gets it.
    now[Math.min(last.index, now.length - 1)]?.focus({ preventScroll: true });
  });
}
