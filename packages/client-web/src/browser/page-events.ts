import type { UbiiClient } from '../core/ubii-client.ts';

/**
 * Makes a client try at once when the network comes back and when the page is shown again: timers of
 * a hidden page sleep, and a phone that wakes should not wait for a back-off. Does nothing outside a
 * page, and while the client is closed.
 */
export function retryOnPageEvents(client: UbiiClient): void {
  const { window: page, document: shown } = globalThis as Partial<typeof globalThis>;
  if (page === undefined || shown === undefined) return;
  const retry = (): void => client.retryNow();
  const retryIfShown = (): void => {
    if (shown.visibilityState === 'visible') client.retryNow();
  };
  client.onState(({ status }) => {
    // The same function is added once, however often.
    if (status === 'connecting') {
      page.addEventListener('online', retry);
      page.addEventListener('pageshow', retry);
      shown.addEventListener('visibilitychange', retryIfShown);
    } else if (status === 'closed') {
      page.removeEventListener('online', retry);
      page.removeEventListener('pageshow', retry);
      shown.removeEventListener('visibilitychange', retryIfShown);
    }
  });
}
