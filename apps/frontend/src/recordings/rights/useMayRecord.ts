import { computed, type ComputedRef } from 'vue';
import { useRole } from '../../connection/useRole.ts';

/** Whether this page may record, keep and change recordings, and start and stop replays. [RC-5] [RP-6] */
export function useMayRecord(): ComputedRef<boolean> {
  const { isViewerOrPlayer } = useRole();
  return computed(() => !isViewerOrPlayer.value);
}
