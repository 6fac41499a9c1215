import { useLocalStorage, useMediaQuery } from '@vueuse/core';
import { computed, type ComputedRef } from 'vue';
import { useRoute } from 'vue-router';

/** From this width on, the labels leave enough room for the pages. */
const WIDE_SCREEN = '(min-width: 1280px)';

/** Pages with columns of their own on both sides: they start with the narrow rail. */
const EDITORS = [/^\/sessions\/[^/]+\/graph/, /^\/modules\/./, /^\/learn\/./];

export interface Rail {
  /** Whether the screen has room for labels. */
  readonly canBeWide: ComputedRef<boolean>;
  /** Whether the labels are shown. */
  readonly isWide: ComputedRef<boolean>;
  toggle(): void;
}

/** Returns true on pages where the labels would take room from an editor. */
export function isEditor(path: string): boolean {
  return EDITORS.some((pattern) => pattern.test(path));
}

/** The rail with or without labels, remembered in this browser, for editors apart from the other pages. */
export function useRail(): Rail {
  const route = useRoute();
  const canBeWide = useMediaQuery(WIDE_SCREEN);
  const wide = useLocalStorage('ubii.rail', { pages: true, editors: false });
  const kind = computed(() => (isEditor(route.path) ? 'editors' : 'pages'));
  return {
    canBeWide,
    isWide: computed(() => canBeWide.value && wide.value[kind.value]),
    toggle: () => {
      wide.value = { ...wide.value, [kind.value]: !wide.value[kind.value] };
    },
  };
}
