import { useEventListener } from '@vueuse/core';
import { useRouter } from 'vue-router';
import type { Shell } from '../page/shell.ts';
import { isSingleKeyShortcut } from '../ui/keys/single-key.ts';
import { useSingleKeyShortcuts } from '../ui/keys/useSingleKeyShortcuts.ts';
import type { RecordingActions } from './useRecordingActions.ts';
import { matchShortcut, PAIR_MS, shortcutsOn, type Shortcut } from './shortcuts.ts';

/** Handles the keyboard shortcuts that work on every page. */
export function useGlobalShortcuts(shell: Shell, recordings: RecordingActions): void {
  const router = useRouter();
  const isEnabled = useSingleKeyShortcuts();
  let pending: string | undefined;
  let pendingSinceMs = 0;

  const mayFire = (event: KeyboardEvent): boolean =>
    isEnabled.value && shell.dialog.value === undefined && isSingleKeyShortcut(event);
  function match(event: KeyboardEvent): ReturnType<typeof matchShortcut> {
    if (event.timeStamp - pendingSinceMs > PAIR_MS) pending = undefined;
    return matchShortcut(pending, event.key, shortcutsOn(router.currentRoute.value.meta));
  }
  function fire({ does }: Shortcut, event: KeyboardEvent): void {
    event.preventDefault();
    if (does.kind === 'go') void router.push(does.to);
    else if (does.kind === 'open') shell.open(does.dialog);
    else recordings[does.kind]();
  }

  // Before the page: the code editor has chords that begin with Ctrl K, and the second key of a sequence may have a
  // meaning of its own, such as M in a graph.
  useEventListener(
    window,
    'keydown',
    (event: KeyboardEvent) => {
      if ((event.ctrlKey || event.metaKey) && !event.altKey && event.key.toLowerCase() === 'k') {
        event.preventDefault();
        event.stopPropagation();
        if (shell.dialog.value === 'palette') shell.close();
        else shell.open('palette');
        return;
      }
      if (pending === undefined || !mayFire(event)) return;
      const { shortcut } = match(event);
      if (!shortcut?.keys.includes(' ')) return;
      pending = undefined;
      event.stopPropagation();
      fire(shortcut, event);
    },
    { capture: true },
  );

  useEventListener(window, 'keydown', (event: KeyboardEvent) => {
    if (!mayFire(event)) {
      pending = undefined;
      return;
    }
    const found = match(event);
    pending = found.pending;
    pendingSinceMs = event.timeStamp;
    if (found.shortcut) fire(found.shortcut, event);
  });
}
