import type { Session } from '@ubii/proto';
import { computed, shallowRef, watch, type ComputedRef } from 'vue';
import { loadingOf, LoadingPace, type ModuleLoading } from '../../sessions/live/module-loading.ts';
import { useSessionStatistics } from '../../sessions/live/useSessionStatistics.ts';

/**
 * Asset set that the modules of a session load before they start: that of the first one that loads something. [PM-94]
 */
export function useSessionLoading(
  session: Readonly<{ value: Session | undefined }>,
): ComputedRef<ModuleLoading | undefined> {
  const statistics = useSessionStatistics();
  const pace = new LoadingPace();
  const loading = shallowRef<ModuleLoading>();
  watch([statistics, () => session.value?.id], ([byId, id]) => {
    const modules = byId.get(id ?? '')?.modules ?? [];
    const now = modules.map(loadingOf).find((one) => one !== undefined);
    loading.value = now && pace.with(now, performance.now());
  });
  return computed(() => loading.value);
}
