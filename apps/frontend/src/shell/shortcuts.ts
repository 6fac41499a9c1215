import { PAGES, SETTINGS_PAGE } from './pages.ts';
import type { ShellDialog } from './shell.ts';

/** What keys do anywhere in the program. */
export interface Shortcut {
  /** One key, or two in a row separated by a space, as `KeyboardEvent.key` names them in upper case. */
  readonly keys: string;
  readonly text: string;
  readonly does:
    | { readonly kind: 'go'; readonly to: string }
    | { readonly kind: 'open'; readonly dialog: ShellDialog };
}

export const SHORTCUTS: readonly Shortcut[] = [
  { keys: '/', text: 'Find or do anything', does: { kind: 'open', dialog: 'palette' } },
  { keys: '?', text: 'Show the keyboard shortcuts', does: { kind: 'open', dialog: 'shortcuts' } },
  { keys: 'C', text: 'Connect a phone', does: { kind: 'open', dialog: 'connect-phone' } },
  ...[...PAGES, SETTINGS_PAGE].map(({ shortcut, title, to }): Shortcut => ({
    keys: shortcut,
    text: `Go to ${title}`,
    does: { kind: 'go', to },
  })),
];

/** What keys do on the row of a list that has the focus; told here, done there. */
export const ROW_KEYS: readonly { readonly keys: string; readonly text: string }[] = [
  { keys: '↑ ↓', text: 'Move between rows' },
  { keys: 'Enter', text: 'Open the row' },
  { keys: 'Space', text: 'Start, pause or resume a session' },
  { keys: 'F2', text: 'Rename a session or a client' },
  { keys: 'Del', text: 'Delete a session or a stored module, disconnect a client' },
];

/** What keys do on the canvas of a graph; told here, done there. */
export const GRAPH_KEYS: readonly { readonly keys: string; readonly text: string }[] = [
  { keys: 'A', text: 'Add a module or topic' },
  { keys: 'F', text: 'Fit the graph' },
  { keys: 'B', text: 'Bypass a module' },
  { keys: 'M', text: 'Mute a module' },
  { keys: 'C', text: 'Collapse a node' },
  { keys: 'Del', text: 'Delete the selection' },
  { keys: 'Shift Del', text: 'Delete and reconnect the neighbours' },
  { keys: 'Ctrl Z', text: 'Undo' },
  { keys: 'Ctrl Y', text: 'Redo' },
  { keys: 'Ctrl A', text: 'Select all' },
  { keys: 'Ctrl C', text: 'Copy (paste here or in another session)' },
  { keys: 'Ctrl D', text: 'Duplicate' },
  { keys: 'Ctrl F', text: 'Find' },
  { keys: 'X', text: 'Detach a node from its wires' },
  { keys: 'I', text: 'Insert a node into the wire under it' },
  { keys: 'W', text: 'Follow the wires of a node' },
  { keys: 'P', text: 'Add a bend point to a wire' },
  { keys: 'Ctrl G', text: 'Add a frame' },
  { keys: 'Alt A D W S', text: 'Align left, right, top, bottom' },
  { keys: 'Space', text: 'and drag: move the canvas' },
  { keys: 'Alt', text: 'and drag: detach from its wires' },
  { keys: 'Shift', text: 'and drag: select with a box' },
  { keys: 'Esc', text: 'Cancel or deselect' },
];

/** How long the second key of a pair may take, milliseconds. */
export const PAIR_MS = 1000;

/** What a key press leads to: a shortcut, the first half of one, or nothing. */
export function matchShortcut(
  pending: string | undefined,
  key: string,
): { readonly shortcut?: Shortcut; readonly pending?: string } {
  const pressed = key.length === 1 ? key.toUpperCase() : key;
  const keys = pending === undefined ? pressed : `${pending} ${pressed}`;
  const shortcut = SHORTCUTS.find((candidate) => candidate.keys === keys);
  if (shortcut) return { shortcut };
  if (SHORTCUTS.some((candidate) => candidate.keys.startsWith(`${keys} `)))
    return { pending: keys };
  // A pair that was not completed may be the start of something else
  return pending === undefined ? {} : matchShortcut(undefined, key);
}
