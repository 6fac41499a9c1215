import { onScopeDispose, toValue, watch, type MaybeRefOrGetter } from 'vue';
import type { Command } from './command.ts';
import { useShell } from './shell.ts';

/** What the palette also finds while the calling component lives: what can be done on its page. */
export function usePageCommands(commands: MaybeRefOrGetter<readonly Command[]>): void {
  const { pageCommands } = useShell();
  watch(
    () => toValue(commands),
    (next) => (pageCommands.value = next),
    { immediate: true },
  );
  onScopeDispose(() => (pageCommands.value = []));
}
