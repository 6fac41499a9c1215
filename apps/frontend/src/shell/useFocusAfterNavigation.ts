import { nextTick } from 'vue';
import { useRouter } from 'vue-router';

/** Time in which dialogs that close have given the focus back, milliseconds. */
const GIVEN_BACK_MS = 50;

/**
 * Shows the beginning of a page that was opened, and focuses its heading, so that the keyboard goes on there. A page that focuses something
 * itself keeps that, and an address with a hash keeps its place.
 */
export function useFocusAfterNavigation(contentId: string): void {
  useRouter().afterEach(async (to, from, failure) => {
    if (failure || to.path === from.path || from.matched.length === 0) return;
    await nextTick();
    const content = document.getElementById(contentId);
    if (content && to.hash === '') content.scrollTop = 0;
    setTimeout(() => {
      const { activeElement } = document;
      const isTaken = content !== activeElement && content?.contains(activeElement);
      if (isTaken || activeElement?.closest('[role="dialog"]')) return;
      const heading = content?.querySelector('h1');
      heading?.setAttribute('tabindex', '-1');
      (heading ?? content)?.focus({ preventScroll: true });
    }, GIVEN_BACK_MS);
  });
}
