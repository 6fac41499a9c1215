import { useLocalStorage, usePreferredDark } from '@vueuse/core';
import { computed, watchEffect, type ComputedRef, type Ref } from 'vue';

export type ThemeChoice = 'system' | 'dark' | 'light';

/** The user's choice of the theme, stored in this browser. */
export function useThemeChoice(): Ref<ThemeChoice> {
  return useLocalStorage<ThemeChoice>('ubii.theme', 'system');
}

/** Whether the dark theme is active. */
export function useIsDark(): ComputedRef<boolean> {
  const choice = useThemeChoice();
  const system = usePreferredDark();
  return computed(() => (choice.value === 'system' ? system.value : choice.value === 'dark'));
}

/** Applies the choice to the document. Call once, at the root. */
export function applyTheme(root: HTMLElement = document.documentElement): void {
  const choice = useThemeChoice();
  const isDark = useIsDark();
  watchEffect(
    () => {
      if (choice.value === 'system') delete root.dataset.theme;
      else root.dataset.theme = choice.value;
      // The browser's own bars get the colour of the rail; read again when the system setting changes.
      void isDark.value;
      const color = getComputedStyle(root).backgroundColor;
      for (const bar of root.ownerDocument.querySelectorAll('meta[name="theme-color"]')) {
        bar.setAttribute('content', color);
      }
    },
    { flush: 'post' },
  );
}
