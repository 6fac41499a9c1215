import { ConnectionError } from '@ubii/client-web';
import { ServiceError } from '@ubii/proto';
import { computed, type ComputedRef } from 'vue';
import { useConnection } from '../../connection/useConnection.ts';
import { useRole } from '../../connection/useRole.ts';
import { useToasts } from '../../ui/toasts/toasts.ts';

/** Roles that may play recordings into live topics. */
const REPLAY_ROLES: ReadonlySet<string> = new Set(['participant', 'admin']);

/** Whether this page may start and stop replays. [RP-6] */
export function useMayReplay(): ComputedRef<boolean> {
  const { role } = useRole();
  return computed(() => role.value === undefined || REPLAY_ROLES.has(role.value));
}

/** Stops replays; says in a toast why the master refused. */
export function useStopReplay(): (id: string) => Promise<void> {
  const { client } = useConnection();
  const toasts = useToasts();
  return async (id) => {
    try {
      await client.call('replayStop', { id });
    } catch (cause) {
      if (!(cause instanceof ServiceError || cause instanceof ConnectionError)) throw cause;
      toasts.show(`Not stopped. ${cause.message}`);
    }
  };
}
