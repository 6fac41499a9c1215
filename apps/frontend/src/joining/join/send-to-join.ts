import type { UbiiClient } from '@ubii/client-web';
import type { Router } from 'vue-router';
import { JOIN_PATH } from '../../locations/join-location.ts';

/** Redirects pages that need joining to the join page, and stores the original target. [AC-5] */
export function sendToJoin(client: Pick<UbiiClient, 'onState'>, router: Router): void {
  client.onState((state) => {
    if (state.status !== 'closed' || state.error?.reason !== 'join') return;
    void router.isReady().then(() => {
      const { meta, fullPath } = router.currentRoute.value;
      if (meta.isBare) return undefined; // Available without joining.
      return router.replace({ path: JOIN_PATH, query: fullPath === '/' ? {} : { to: fullPath } });
    });
  });
}
