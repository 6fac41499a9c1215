import { useLocalStorage } from '@vueuse/core';
import type { Ref } from 'vue';
import type { ModuleEntry } from '../../modules/library/module-entry.ts';

/** Modules that come first. */
const MAX_RECENT = 5;

/** Names of the modules used last, newest first; this browser remembers. */
export function useRecentModules(): {
  readonly names: Readonly<Ref<readonly string[]>>;
  note(name: string): void;
} {
  const names = useLocalStorage<string[]>('ubii.recentModules', []);
  return {
    names,
    note: (name) => (names.value = withRecent(names.value, name)),
  };
}

export function withRecent(names: readonly string[], name: string): string[] {
  return [name, ...names.filter((one) => one !== name)].slice(0, MAX_RECENT);
}

/** Those used last, then the others in their order. */
export function recentFirst(
  entries: readonly ModuleEntry[],
  recent: readonly string[],
): { readonly recent: readonly ModuleEntry[]; readonly others: readonly ModuleEntry[] } {
  const first = recent.flatMap((name) => entries.find(({ module }) => module.name === name) ?? []);
  return { recent: first, others: entries.filter((entry) => !first.includes(entry)) };
}
