import { useEventListener } from '@vueuse/core';
import type { SessionCommand } from './session-command.ts';

const KEYS: Readonly<Record<string, string>> = {
  s: 'save',
  'shift s': 'save-as',
  o: 'open',
  enter: 'start',
  'shift enter': 'stop',
};

/** Handles F2, Ctrl S and other session shortcuts, wherever the focus is; otherwise browsers save the page. */
export function useSessionKeys(commands: () => readonly SessionCommand[]): void {
  useEventListener(window, 'keydown', (event: KeyboardEvent) => {
    if (event.altKey || event.defaultPrevented) return;
    const key = `${event.shiftKey ? 'shift ' : ''}${event.key.toLowerCase()}`;
    const id = event.ctrlKey || event.metaKey ? KEYS[key] : key === 'f2' ? 'rename' : undefined;
    if (id === undefined) return;
    // An open dialog blocks the commands of the page.
    event.preventDefault();
    if (document.querySelector('[role="dialog"][data-state="open"]')) return;
    const command = commands().find((one) => one.id === id);
    if (command && command.isDisabled !== true) command.run();
  });
}
