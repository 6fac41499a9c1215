import type { Session } from '@ubii/proto';
import { shallowRef, watch, type ShallowRef } from 'vue';
import type { ModulePlace } from '../../sessions/own/planned-session.ts';
import { useSessionStatistics } from '../../sessions/live/useSessionStatistics.ts';

type Measured = ReadonlyMap<ModulePlace, { readonly ms: number; readonly hint: string }>;

/** Median run time of a session's module, by node that was tried. */
export function useMeasuredPlaces(
  session: Readonly<{ value: Session | undefined }>,
  place: Readonly<{ value: ModulePlace }>,
): Readonly<ShallowRef<Measured>> {
  const statistics = useSessionStatistics();
  const measured = shallowRef<Measured>(new Map());
  const moduleOf = (one: Session | undefined): string | undefined =>
    one?.processingModules[0]?.name;
  watch(
    () => moduleOf(session.value),
    () => (measured.value = new Map()),
  );
  watch(statistics, (byId) => {
    const [module] = session.value?.processingModules ?? [];
    const now = byId
      .get(session.value?.id ?? '')
      ?.modules.find(
        ({ moduleId, nodeId }) => moduleId === module?.id && nodeId === module?.nodeId,
      );
    if (!now || now.runsPerSecond === 0) return;
    measured.value = new Map(measured.value).set(place.value, { ms: now.runP50Ms, hint: '' });
  });
  return measured;
}
