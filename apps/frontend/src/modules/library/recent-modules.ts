import { useLocalStorage } from '@vueuse/core';
import * as v from 'valibot';
import type { Ref } from 'vue';
import { storedAs } from '../../json/read-stored.ts';
import { validElements } from '../../json/schemas.ts';
import { isDeletable, type ModuleEntry } from './module-entry.ts';

/** Number of recently used modules at the top. */
const MAX_RECENT = 5;
const STORED = storedAs(validElements(v.string(), MAX_RECENT), []);

/** Names of recently used modules, newest first; stored in this browser. */
export function useRecentModules(): {
  readonly names: Readonly<Ref<readonly string[]>>;
  note(name: string): void;
} {
  const names = useLocalStorage<string[]>('ubii.recentModules', [], { serializer: STORED });
  return {
    names,
    note: (name) => (names.value = withRecent(names.value, name)),
  };
}

export function withRecent(names: readonly string[], name: string): string[] {
  return [name, ...names.filter((one) => one !== name)].slice(0, MAX_RECENT);
}

/** Groups modules: written on this master, recently used, others; each in the original order. */
export function groupModules(
  entries: readonly ModuleEntry[],
  recentNames: readonly string[],
): Readonly<Record<'own' | 'recent' | 'others', readonly ModuleEntry[]>> {
  const own = entries.filter(isDeletable);
  const rest = entries.filter((entry) => !own.includes(entry));
  const recent = recentNames.flatMap(
    (name) => rest.find(({ module }) => module.name === name) ?? [],
  );
  return { own, recent, others: rest.filter((entry) => !recent.includes(entry)) };
}
