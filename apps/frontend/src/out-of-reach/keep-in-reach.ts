import { isThisMachine } from '../joining/join/this-machine.ts';
import { isInstalled } from '../install/install-offer.ts';

/** Built from `service-worker.ts` by `service-worker-plugin.js`. */
const SERVICE_WORKER = '/service-worker.js';

/**
 * Registers a service worker that shows a message when a page cannot be loaded: on phones and in the installed app. Not
 * on the master's own computer, where other programs may use the same origin.
 */
export function keepInReach(): void {
  const isHere = isThisMachine();
  if (!import.meta.env.PROD || (isHere && !isInstalled())) return;
  // Not available over plain HTTP; refused for a certificate that was accepted without being trusted.
  navigator.serviceWorker?.register(SERVICE_WORKER).catch(() => undefined);
}
