import { computed, ref } from 'vue';
import { useAttempt } from '../../connection/useAttempt.ts';
import { useConnection } from '../../connection/useConnection.ts';
import { useRole } from '../../connection/useRole.ts';
import { isThisMachine } from '../join/this-machine.ts';

/** Enables the local network on a master that listens on loopback only. [AC-47] */
export function useLan() {
  const { client } = useConnection();
  const { role, isNoAdmin } = useRole();
  const state = ref<'off' | 'opening' | 'on'>('off');
  const { problem: error, attempt } = useAttempt();
  /** Allowed for admins on the master's computer only. */
  const mayOpen = computed(() => role.value === 'admin' && isThisMachine());

  async function open(): Promise<void> {
    if (state.value !== 'off') return;
    state.value = 'opening';
    try {
      await attempt(async () => {
        await client.call('lanOpen');
        state.value = 'on';
      });
    } finally {
      if (state.value === 'opening') state.value = 'off';
    }
  }

  return { state, error, mayOpen, isNoAdmin, open };
}
