import type { ComputedRef } from 'vue';
import { useRouter } from 'vue-router';
import { useConnection } from '../../connection/useConnection.ts';
import { usePageInputs } from '../../examples/gallery/inputs/page-inputs.ts';
import { sessionLocation } from '../../locations/session-location.ts';
import { useOwnedSession } from '../../sessions/own/useOwnedSession.ts';
import { useToasts } from '../../ui/toasts/toasts.ts';
import { isOwnSession, ownSession } from './first-session.ts';

/** Makes the session of Home one's own: starts a copy that stays, and opens it. */
export function useKeptSession(): {
  readonly isBusy: ComputedRef<boolean>;
  keep(): Promise<void>;
} {
  const { client } = useConnection();
  const router = useRouter();
  const toasts = useToasts();
  const pageInputs = usePageInputs();
  const { isBusy, trouble, start } = useOwnedSession({
    life: 'shared',
    isOwn: (session) => isOwnSession(session, client.id),
    spec: () => ownSession(client.id),
  });

  return {
    isBusy,
    async keep() {
      const session = await start();
      if (session === undefined) {
        if (trouble.value !== undefined)
          toasts.show(`The session was not started. ${trouble.value}`);
        return;
      }
      pageInputs.give(session.id, ['pointer']);
      await router.push(sessionLocation(session.id));
    },
  };
}
