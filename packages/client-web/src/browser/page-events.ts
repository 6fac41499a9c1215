import type { UbiiClient } from '../core/client/ubii-client.ts';

/** The network of a device, where the browser reports it: after a change of Wi-Fi, a socket stays open without data. */
interface NetworkConnection {
  readonly connection?: EventTarget;
}

/**
 * Makes a client try at once, or make sure that its link is alive, when something tells that the page
 * or the network is back or another one: timers of a hidden page sleep, and a phone that wakes should
 * not wait for a back-off. [CL-41] When the page ends, the client deregisters, so that other clients do not see it as
 * lost. [EX-55] Does nothing outside a page, and while the client is closed.
 */
export function followPageEvents(client: UbiiClient): void {
  const { window: page, document: shown, navigator } = globalThis as Partial<typeof globalThis>;
  if (page === undefined || shown === undefined) return;
  const retry = (): void => client.retryNow();
  let isEnding = false;
  const handlePageHide = (event: Event): void => {
    // A page that is kept may come back, and the socket may even live on.
    if ((event as PageTransitionEvent).persisted) return;
    // A visible page is hidden after all listeners have handled its end and sent their last
    // messages. https://html.spec.whatwg.org/#unload-a-document
    isEnding = shown.visibilityState === 'visible';
    if (!isEnding) client.leave();
  };
  const handleVisibility = (): void => {
    if (isEnding) client.leave();
    else if (shown.visibilityState === 'visible') client.retryNow();
  };
  const network = (navigator as NetworkConnection | undefined)?.connection;
  const events: readonly [EventTarget | undefined, string, (event: Event) => void][] = [
    [page, 'online', retry],
    // The link is gone most likely: the sooner that is known, the sooner another one is looked for.
    [page, 'offline', retry],
    [page, 'pageshow', retry],
    [page, 'pagehide', handlePageHide],
    [shown, 'visibilitychange', handleVisibility],
    [shown, 'resume', retry],
    [network, 'change', retry],
  ];
  client.onState(({ status }) => {
    for (const [target, type, handle] of events) {
      // The same function is added once, however often.
      if (status === 'connecting') target?.addEventListener(type, handle);
      else if (status === 'closed') target?.removeEventListener(type, handle);
    }
  });
}
