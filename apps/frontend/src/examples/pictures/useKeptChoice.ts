import { useSessionStorage, type RemovableRef } from '@vueuse/core';
import { useRoute } from 'vue-router';
import type { ModulePlace } from '../../sessions/own/planned-session.ts';

/** What people chose on this page; this tab keeps it over reloads. @param isGood whether a kept value is one still */
export function useKeptChoice<T>(
  name: string,
  initial: T,
  isGood: (kept: T) => boolean = () => true,
): RemovableRef<T> {
  const kept = useSessionStorage<T>(`ubii.example${useRoute().path}.${name}`, initial, {
    mergeDefaults: true,
  });
  if (!isGood(kept.value)) kept.value = initial;
  return kept;
}

/** Where the module runs; other nodes may be gone after a reload. */
export function useKeptPlace(): RemovableRef<ModulePlace> {
  return useKeptChoice<ModulePlace>('place', 'tab', (kept) => kept === 'master');
}
