import { useMediaQuery } from '@vueuse/core';
import { computed, type ComputedRef } from 'vue';
import { useRoute } from 'vue-router';

/** Screen width from which labels leave enough room for pages. */
const WIDE_SCREEN = '(min-width: 1280px)';

/** Whether the rail shows labels: where the screen has room for them, and not on pages from edge to edge. */
export function useRail(): { readonly isWide: ComputedRef<boolean> } {
  const route = useRoute();
  const isWideScreen = useMediaQuery(WIDE_SCREEN);
  return { isWide: computed(() => isWideScreen.value && route.meta.isFullBleed !== true) };
}
