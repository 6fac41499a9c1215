import { useLocalStorage, usePreferredDark } from '@vueuse/core';
import { computed, watchEffect, type ComputedRef, type Ref } from 'vue';

export type ThemeChoice = 'system' | 'dark' | 'light';

/** The theme a person chose for this browser, remembered. */
export function useThemeChoice(): Ref<ThemeChoice> {
  return useLocalStorage<ThemeChoice>('ubii.theme', 'system');
}

/** What is drawn now. */
export function useIsDark(): ComputedRef<boolean> {
  const choice = useThemeChoice();
  const system = usePreferredDark();
  return computed(() => (choice.value === 'system' ? system.value : choice.value === 'dark'));
}

/** Keeps the document as chosen. Call once, at the root. */
export function applyTheme(root: HTMLElement = document.documentElement): void {
  const choice = useThemeChoice();
  const isDark = useIsDark();
  watchEffect(
    () => {
      if (choice.value === 'system') delete root.dataset.theme;
      else root.dataset.theme = choice.value;
      // The browser's own bars take the colour of the rail. Read again when the system switches.
      void isDark.value;
      const color = getComputedStyle(root).backgroundColor;
      for (const bar of root.ownerDocument.querySelectorAll('meta[name="theme-color"]')) {
        bar.setAttribute('content', color);
      }
    },
    { flush: 'post' },
  );
}
