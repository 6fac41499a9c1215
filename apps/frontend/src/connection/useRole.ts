import type { ClientRole } from '@ubii/client-web';
import { computed, type ComputedRef } from 'vue';
import { useConnection } from './useConnection.ts';

/** What this page may do at the master. */
export interface OwnRole {
  /** `undefined` while not connected, and at masters that know no roles. */
  readonly role: ComputedRef<ClientRole | undefined>;
  /** It is admitted, and not to what only admins may. [AC-21] */
  readonly isNoAdmin: ComputedRef<boolean>;
}

export function useRole(): OwnRole {
  const { client, state } = useConnection();
  const role = computed(() => (state.value.status === 'connected' ? client.role : undefined));
  return { role, isNoAdmin: computed(() => role.value !== undefined && role.value !== 'admin') };
}
