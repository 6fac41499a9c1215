import { SERVICES, toJson } from '@ubii/proto';
import { useEventListener } from '@vueuse/core';

/**
 * Removes a session when its page is closed or left by navigation. Such a page cannot wait for a reply.
 *
 * @param id returns `undefined` while there is none to remove
 */
export function removeOnPageHide(id: () => string | undefined): void {
  useEventListener(window, 'pagehide', () => {
    const gone = id();
    if (gone === undefined) return;
    const request = { topic: SERVICES.sessionRuntimeRemove.topic, session: { id: gone } };
    const body = JSON.stringify(toJson('ubii.services.ServiceRequest', request));
    navigator.sendBeacon('/services/json', new Blob([body], { type: 'application/json' }));
  });
}
