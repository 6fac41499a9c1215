import { useEventListener } from '@vueuse/core';
import { useRouter } from 'vue-router';
import type { Shell } from '../page/shell.ts';
import { isSingleKeyShortcut } from '../ui/keys/single-key.ts';
import { useSingleKeyShortcuts } from '../ui/keys/useSingleKeyShortcuts.ts';
import type { RecordingActions } from './useRecordingActions.ts';
import { matchShortcut, PAIR_MS, shortcutsOn } from './shortcuts.ts';

/** Handles the keyboard shortcuts that work on every page. */
export function useGlobalShortcuts(shell: Shell, recordings: RecordingActions): void {
  const router = useRouter();
  const isEnabled = useSingleKeyShortcuts();
  let pending: string | undefined;
  let pendingSinceMs = 0;

  useEventListener(window, 'keydown', (event: KeyboardEvent) => {
    if ((event.ctrlKey || event.metaKey) && !event.altKey && event.key.toLowerCase() === 'k') {
      event.preventDefault();
      if (shell.dialog.value === 'palette') shell.close();
      else shell.open('palette');
      return;
    }
    const mayFire =
      isEnabled.value && shell.dialog.value === undefined && isSingleKeyShortcut(event);
    if (!mayFire) {
      pending = undefined;
      return;
    }

    if (event.timeStamp - pendingSinceMs > PAIR_MS) pending = undefined;
    const match = matchShortcut(pending, event.key, shortcutsOn(router.currentRoute.value.meta));
    pending = match.pending;
    pendingSinceMs = event.timeStamp;
    if (!match.shortcut) return;
    event.preventDefault();
    const { does } = match.shortcut;
    if (does.kind === 'go') void router.push(does.to);
    else if (does.kind === 'open') shell.open(does.dialog);
    else recordings[does.kind]();
  });
}
