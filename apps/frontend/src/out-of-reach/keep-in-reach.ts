import { isThisMachine } from '../joining/join/this-machine.ts';
import { isInstalled } from '../install/install-offer.ts';

/** Built from `service-worker.ts` by `service-worker-plugin.js`. */
const SERVICE_WORKER = '/service-worker.js';

/**
 * Where a page that cannot be loaded does not help, words take its place: on phones and in the installed app.
 * The machine of the master has them not: its addresses belong to other programs, too.
 */
export function keepInReach(): void {
  const isHere = isThisMachine();
  if (!import.meta.env.PROD || (isHere && !isInstalled())) return;
  // Missing over plain HTTP; refused where the certificate was accepted, but is not trusted
  navigator.serviceWorker?.register(SERVICE_WORKER).catch(() => undefined);
}
