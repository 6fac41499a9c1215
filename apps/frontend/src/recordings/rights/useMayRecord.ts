import { computed, type ComputedRef } from 'vue';
import { useRole } from '../../connection/useRole.ts';

/** Whether this page may record and keep, and use own recordings and replays; those of others are for admins. [RC-66] */
export function useMayRecord(): ComputedRef<boolean> {
  const { isViewerOrPlayer } = useRole();
  return computed(() => !isViewerOrPlayer.value);
}
