import { ConnectionError } from '@ubii/client-web';
import { ServiceError } from '@ubii/proto';
import { shallowRef, type Ref } from 'vue';
import { useRouter } from 'vue-router';
import { useConnection } from '../../connection/useConnection.ts';
import { usePageInputs } from '../../examples/gallery/inputs/page-inputs.ts';
import { sessionLocation } from '../../locations/session-location.ts';
import { isAlive } from '../../sessions/state/session-state.ts';
import { useToasts } from '../../ui/toasts/toasts.ts';
import { isOwnSession, ownSession } from './first-session.ts';

/** Makes the session of Home one's own: starts a copy that stays, and opens it. */
export function useKeptSession(): {
  readonly isBusy: Readonly<Ref<boolean>>;
  keep(): Promise<void>;
} {
  const { client, sessions } = useConnection();
  const router = useRouter();
  const toasts = useToasts();
  const pageInputs = usePageInputs();
  const isBusy = shallowRef(false);

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
      isBusy.value = true;
      try {
        const id = await startOwn();
        pageInputs.give(id, ['pointer']);
        await router.push(sessionLocation(id));
      } catch (cause) {
        if (!(cause instanceof ServiceError || cause instanceof ConnectionError)) throw cause;
        toasts.show(`The session was not started. ${cause.message}`);
      } finally {
        isBusy.value = false;
      }
    },
  };
}
