import type { UbiiClient } from '@ubii/client-web';
import { SERVICES } from '@ubii/proto';
import { useEventListener } from '@vueuse/core';
import { sendAtPageHide } from '../../connection/send-at-page-hide.ts';

/**
 * Removes a session of a client when its page is closed or left by navigation.
 *
 * @param id returns `undefined` while there is none to remove
 */
export function removeOnPageHide(
  client: Pick<UbiiClient, 'authorization'>,
  id: () => string | undefined,
): void {
  useEventListener(window, 'pagehide', () => {
    const gone = id();
    if (gone === undefined) return;
    sendAtPageHide(client, { topic: SERVICES.sessionRuntimeRemove.topic, session: { id: gone } });
  });
}
