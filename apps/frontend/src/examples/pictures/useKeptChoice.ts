import { useSessionStorage, type RemovableRef } from '@vueuse/core';
import { useRoute } from 'vue-router';
import type { ModulePlace } from '../../sessions/own/planned-session.ts';

/**
 * A choice of the user on this page, kept in this tab over reloads. @param isGood whether a stored value is still valid
 */
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

/** Node of the module. Only the master is restored after a reload; other nodes may be gone. */
export function useKeptPlace(): RemovableRef<ModulePlace> {
  return useKeptChoice<ModulePlace>('place', 'tab', (kept) => kept === 'master');
}
