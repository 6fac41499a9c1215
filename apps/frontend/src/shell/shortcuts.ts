import type { ShellDialog } from '../page/shell.ts';
import { PAGES } from './pages.ts';

/** Keyboard shortcut that works on every page. */
export interface Shortcut {
  /** One key, or two in a row separated by a space, as `KeyboardEvent.key` names them in upper case. */
  readonly keys: string;
  readonly text: string;
  readonly does:
    | { readonly kind: 'go'; readonly to: string }
    | { readonly kind: 'open'; readonly dialog: ShellDialog }
    | { readonly kind: 'keep' | 'mark' };
}

export const SHORTCUTS: readonly Shortcut[] = [
  { keys: '/', text: 'Search or run a command', does: { kind: 'open', dialog: 'palette' } },
  { keys: '?', text: 'Show the keyboard shortcuts', does: { kind: 'open', dialog: 'shortcuts' } },
  { keys: 'C', text: 'Connect a phone', does: { kind: 'open', dialog: 'connect-phone' } },
  { keys: 'K', text: 'Keep the last minutes of the flight recorder', does: { kind: 'keep' } },
  { keys: 'M', text: 'Mark this moment in what is recorded', does: { kind: 'mark' } },
  ...PAGES.map(({ shortcut, title, to }): Shortcut => ({
    keys: shortcut,
    text: `Go to ${title}`,
    does: { kind: 'go', to },
  })),
];

/** Longest time between the two keys of a sequence, milliseconds. */
export const PAIR_MS = 1000;

/** Returns the shortcuts available on a page; single keys with another meaning there are omitted. */
export function shortcutsOn({ ownKeys = '' }: { readonly ownKeys?: string }): readonly Shortcut[] {
  return SHORTCUTS.filter(({ keys }) => keys.length > 1 || !ownKeys.includes(keys));
}

/** Matches a key press: a shortcut, the first key of a sequence, or nothing. */
export function matchShortcut(
  pending: string | undefined,
  key: string,
  shortcuts: readonly Shortcut[] = SHORTCUTS,
): { readonly shortcut?: Shortcut; readonly pending?: string } {
  const pressed = key.length === 1 ? key.toUpperCase() : key;
  const keys = pending === undefined ? pressed : `${pending} ${pressed}`;
  const shortcut = shortcuts.find((candidate) => candidate.keys === keys);
  if (shortcut) return { shortcut };
  if (shortcuts.some((candidate) => candidate.keys.startsWith(`${keys} `)))
    return { pending: keys };
  // After an incomplete sequence, the key may start another one.
  return pending === undefined ? {} : matchShortcut(undefined, key, shortcuts);
}
