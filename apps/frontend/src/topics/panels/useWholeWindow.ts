import { useEventListener, useFullscreen } from '@vueuse/core';
import { ref, watch, type Ref } from 'vue';
import { isSingleKeyShortcut } from '../../ui/keys/single-key.ts';
import { useSingleKeyShortcuts } from '../../ui/keys/useSingleKeyShortcuts.ts';

/**
 * Shows an element in the whole window, and the window in full screen where the browser allows it. The key F toggles.
 * Full screen has the whole document, because menus and dialogs are outside the element.
 */
export function useWholeWindow(mayBegin: () => boolean): {
  readonly isWhole: Readonly<Ref<boolean>>;
  toggle(): void;
} {
  const isWhole = ref(false);
  const hasKeys = useSingleKeyShortcuts();
  const { isFullscreen, enter, exit } = useFullscreen();
  watch(isFullscreen, (isOn) => {
    if (!isOn) isWhole.value = false;
  });
  function toggle(): void {
    if (!isWhole.value && !mayBegin()) return;
    isWhole.value = !isWhole.value;
    // Browsers that refuse show the element in the whole window.
    void (isWhole.value ? enter() : exit()).catch(() => undefined);
  }
  let before = '';
  useEventListener(document, 'keydown', (event: KeyboardEvent) => {
    // G F goes to another page.
    const isPair = before === 'g';
    before = event.key.toLowerCase();
    if (isPair || !hasKeys.value || !isSingleKeyShortcut(event)) return;
    const isEscape = event.key === 'Escape' && isWhole.value;
    if (!isEscape && event.key.toLowerCase() !== 'f') return;
    event.preventDefault();
    toggle();
  });
  return { isWhole, toggle };
}
