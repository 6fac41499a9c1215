import type { ClientRole } from '@ubii/client-web';
import { computed, type ComputedRef } from 'vue';
import { useConnection } from './useConnection.ts';

/** Role of this page's client. */
export interface OwnRole {
  /** `undefined` while disconnected, and on masters without roles. */
  readonly role: ComputedRef<ClientRole | undefined>;
  /** True when admitted without admin rights. [AC-21] */
  readonly isNoAdmin: ComputedRef<boolean>;
  /** Viewers and players neither make nor read recordings and studies. [AC-21] */
  readonly isViewerOrPlayer: ComputedRef<boolean>;
}

export function useRole(): OwnRole {
  const { client, state } = useConnection();
  const role = computed(() => (state.value.status === 'connected' ? client.role : undefined));
  return {
    role,
    isNoAdmin: computed(() => role.value !== undefined && role.value !== 'admin'),
    isViewerOrPlayer: computed(() => role.value === 'viewer' || role.value === 'player'),
  };
}
