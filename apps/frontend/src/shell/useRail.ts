import { useLocalStorage, useMediaQuery } from '@vueuse/core';
import { computed, type ComputedRef } from 'vue';
import { useRoute } from 'vue-router';

/** Screen width from which labels leave enough room for pages. */
const WIDE_SCREEN = '(min-width: 1280px)';

/** Pages with side panels of their own: they start with the narrow rail. */
const EDITORS = [/^\/sessions\/[^/]+\/graph/, /^\/modules\/./, /^\/learn\/./];

export interface Rail {
  /** Whether the screen has room for labels. */
  readonly canBeWide: ComputedRef<boolean>;
  /** Whether the labels are shown. */
  readonly isWide: ComputedRef<boolean>;
  toggle(): void;
}

/** Returns true on pages where labels would take space from an editor. */
export function isEditor(path: string): boolean {
  return EDITORS.some((pattern) => pattern.test(path));
}

/** State of the rail, with or without labels; stored in this browser, separately for editors and other pages. */
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
