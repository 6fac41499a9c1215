import { useEventListener, useMutationObserver } from '@vueuse/core';
import { onMounted, type Ref } from 'vue';
import { isTypeAhead, TypeAhead } from './type-ahead.ts';

const STEPS: Readonly<Record<string, (index: number, count: number) => number>> = {
  ArrowDown: (index, count) => Math.min(index + 1, count - 1),
  ArrowUp: (index) => Math.max(index - 1, 0),
  Home: () => 0,
  End: (_, count) => count - 1,
};

/**
 * Makes the items of an element one Tab stop: Up, Down, Home, End and type-ahead move among them. Tab returns to the
 * item that had the focus last.
 * @param selector of the items
 */
export function useRoving(host: Readonly<Ref<HTMLElement | null>>, selector: string): void {
  const items = (): HTMLElement[] => [
    ...(host.value?.querySelectorAll<HTMLElement>(selector) ?? []),
  ];
  function stopAt(stop: HTMLElement | undefined): void {
    for (const item of items()) item.tabIndex = item === stop ? 0 : -1;
  }
  let last: HTMLElement | undefined;
  function settle(): void {
    const all = items();
    if (last !== undefined && !all.includes(last)) last = undefined;
    stopAt(last ?? all[0]);
  }
  onMounted(settle);
  useMutationObserver(host, settle, { childList: true, subtree: true });
  useEventListener(host, 'focusin', ({ target }: FocusEvent) => {
    if (!(target instanceof HTMLElement) || !target.matches(selector)) return;
    last = target;
    stopAt(last);
  });
  const typeAhead = new TypeAhead();
  useEventListener(host, 'keydown', (event: KeyboardEvent) => {
    const all = items();
    const index = all.indexOf(event.target as HTMLElement);
    if (index === -1) return;
    const step = STEPS[event.key];
    const isPlain = !event.ctrlKey && !event.metaKey && !event.altKey && !event.shiftKey;
    if (step !== undefined && isPlain) {
      event.preventDefault();
      all[step(index, all.length)]?.focus();
    } else if (isTypeAhead(event)) {
      event.preventDefault(); // Also prevents single-key shortcuts.
      const texts = all.map(({ textContent }) => textContent.trim().toLowerCase());
      const found = typeAhead.type(event.key, texts, index, event.timeStamp);
      if (found !== undefined) all[found]?.focus();
    }
  });
}
