import { computed, type ComputedRef } from 'vue';
import { useRole } from '../../connection/useRole.ts';

/** Roles that may record, keep and change recordings, and play them into live topics. */
const ROLES: ReadonlySet<string> = new Set(['participant', 'admin']);

/** Whether this page may record, keep and change recordings, and start and stop replays. [RC-5] [RP-6] */
export function useMayRecord(): ComputedRef<boolean> {
  const { role } = useRole();
  return computed(() => role.value === undefined || ROLES.has(role.value));
}
