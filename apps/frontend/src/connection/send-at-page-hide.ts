import type { UbiiClient } from '@ubii/client-web';
import { toJson, type Init, type ServiceRequest } from '@ubii/proto';

const SERVICES_PATH = '/services/json';

/** Sends a service request, as this client, from a page that is being closed: it cannot wait for a reply. */
export function sendAtPageHide(
  { authorization }: Pick<UbiiClient, 'authorization'>,
  request: Init<ServiceRequest>,
): void {
  const body = JSON.stringify(toJson('ubii.services.ServiceRequest', request));
  const type = 'application/json';
  // Beacons have no headers: the master would not know whose request it is.
  if ('keepalive' in Request.prototype) {
    const headers = {
      'Content-Type': type,
      ...(authorization && { Authorization: authorization }),
    };
    const sent = fetch(SERVICES_PATH, { method: 'POST', keepalive: true, headers, body });
    sent.catch(() => undefined);
  } else navigator.sendBeacon(SERVICES_PATH, new Blob([body], { type }));
}
