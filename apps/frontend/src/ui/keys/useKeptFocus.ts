import { useEventListener } from '@vueuse/core';
import { onUpdated, type Ref } from 'vue';

/**
 * Keeps the keyboard focus among the buttons of an element: when the focused button disappears, the one at its position
 * is focused. Call it in the component that renders them.
 */
export function useKeptFocus(host: Readonly<Ref<HTMLElement | null>>): void {
  const buttons = (): HTMLElement[] => [...(host.value?.querySelectorAll('button') ?? [])];
  /** The button that has or had the focus, and its index. */
  let last: { readonly element: HTMLElement; readonly index: number } | undefined;

  useEventListener(document, 'focusin', ({ target }: FocusEvent) => {
    const index = buttons().indexOf(target as HTMLElement);
    last = index === -1 ? undefined : { element: target as HTMLElement, index };
  });
  // A pointer press elsewhere ends it, also on elements that cannot have the focus.
  useEventListener(document, 'pointerdown', ({ target }: PointerEvent) => {
    if (host.value?.contains(target as Node) !== true) last = undefined;
  });
  onUpdated(() => {
    if (last === undefined || last.element.isConnected) return;
    if (document.activeElement !== document.body) return;
    const now = buttons();
    // Without any button, such as while a session stops, the next one to appear is focused.
    now[Math.min(last.index, now.length - 1)]?.focus({ preventScroll: true });
  });
}
