import type { ComputedRef } from 'vue';
import { useRouter } from 'vue-router';
import { useAttempt } from '../../connection/useAttempt.ts';
import { useConnection } from '../../connection/useConnection.ts';
import { usePageInputs } from '../../examples/gallery/inputs/page-inputs.ts';
import { sessionLocation } from '../../locations/session-location.ts';
import { isAlive } from '../../sessions/state/session-state.ts';
import { useToasts } from '../../ui/toasts/toasts.ts';
import { isOwnSession, ownSession } from './first-session.ts';

/** Makes the session of Home one's own: starts a copy that stays, and opens it. */
export function useKeptSession(): {
  readonly isBusy: ComputedRef<boolean>;
  keep(): Promise<void>;
} {
  const { client, sessions } = useConnection();
  const router = useRouter();
  const toasts = useToasts();
  const pageInputs = usePageInputs();
  const { problem, isBusy, attempt } = useAttempt();

  async function startOwn(): Promise<string> {
    const known = sessions.list.value?.find((one) => isOwnSession(one, client.id));
    if (known && isAlive(known)) return known.id;
    const spec = known ? { id: known.id } : ownSession(client.id);
    const started = await client.call('sessionRuntimeStart', spec);
    sessions.take(started);
    return started.id;
  }

  return {
    isBusy,
    async keep() {
      if (isBusy.value) return;
      await attempt(async () => {
        const id = await startOwn();
        pageInputs.give(id, ['pointer']);
        await router.push(sessionLocation(id));
      });
      if (problem.value !== undefined) toasts.show(`The session was not started. ${problem.value}`);
    },
  };
}
