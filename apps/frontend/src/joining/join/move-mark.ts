import { loadRouteLocation, type Router } from 'vue-router';

/**
 * Replaces the page, and lets the own mark move to its place on the next one: both have the `view-transition-name` `own-mark`. At once
 * where the browser cannot, or the person wants less motion.
 */
export async function replaceWithMark(router: Router, target: string): Promise<void> {
  const isStill = matchMedia('(prefers-reduced-motion: reduce)').matches;
  if (isStill || typeof document.startViewTransition !== 'function') {
    await router.replace(target);
    return;
  }
  // Nothing is drawn during a transition, so that the page is loaded before it.
  await loadRouteLocation(router.resolve(target));
  await document.startViewTransition(() => router.replace(target)).updateCallbackDone;
}
