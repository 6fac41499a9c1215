import type { UbiiClient } from '@ubii/client-web';
import type { Router } from 'vue-router';
import { JOIN_PATH } from '../../locations/join-location.ts';

/** Takes a page that has to join first to where it can, and remembers where it wanted to go. [AC-5] */
export function sendToJoin(client: Pick<UbiiClient, 'onState'>, router: Router): void {
  client.onState((state) => {
    if (state.status !== 'closed' || state.error?.reason !== 'join') return;
    void router.isReady().then(() => {
      const { meta, fullPath } = router.currentRoute.value;
      if (meta.isBare) return undefined; // for strangers, too
      return router.replace({ path: JOIN_PATH, query: fullPath === '/' ? {} : { to: fullPath } });
    });
  });
}
