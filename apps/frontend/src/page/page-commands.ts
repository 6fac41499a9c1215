import { onScopeDispose, toValue, watch, type MaybeRefOrGetter } from 'vue';
import type { Command } from './command.ts';
import { useShell } from './shell.ts';

/** Adds commands of the current page to the palette, while the calling component is mounted. */
export function usePageCommands(commands: MaybeRefOrGetter<readonly Command[]>): void {
  const { pageCommands } = useShell();
  watch(
    () => toValue(commands),
    (next) => (pageCommands.value = next),
    { immediate: true },
  );
  onScopeDispose(() => (pageCommands.value = []));
}
