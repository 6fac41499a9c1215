import { ConnectionError } from '@ubii/client-web';
import { ServiceError } from '@ubii/proto';
import { computed, ref } from 'vue';
import { useConnection } from '../../connection/useConnection.ts';
import { useRole } from '../../connection/useRole.ts';
import { isThisMachine } from '../join/this-machine.ts';

/** Enables the local network on a master that listens on loopback only. [AC-47] */
export function useLan() {
  const { client } = useConnection();
  const { role, isNoAdmin } = useRole();
  const state = ref<'off' | 'opening' | 'on'>('off');
  const error = ref('');
  /** Allowed for admins on the master's computer only. */
  const mayOpen = computed(() => role.value === 'admin' && isThisMachine());

  async function open(): Promise<void> {
    if (state.value !== 'off') return;
    state.value = 'opening';
    error.value = '';
    try {
      await client.call('lanOpen');
      state.value = 'on';
    } catch (cause) {
      state.value = 'off';
      if (!(cause instanceof ServiceError || cause instanceof ConnectionError)) throw cause;
      error.value = cause.message;
    }
  }

  return { state, error, mayOpen, isNoAdmin, open };
}
