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

/** What keys do on the canvas of a graph; handled in graph/canvas/canvas-keys.ts. */
export const GRAPH_KEYS: readonly { readonly keys: string; readonly text: string }[] = [
  { keys: '← → ↑ ↓', text: 'Go to the next node, to its sockets, and along wires' },
  { keys: 'L', text: 'Start a wire: choose what it connects to' },
  { keys: 'A', text: 'Add a module or topic' },
  { keys: 'Enter', text: 'Show details of a node, or take up a wire at a socket' },
  { keys: 'Esc', text: 'Cancel, leave the socket, or clear the selection' },
  { keys: 'Shift ← → ↑ ↓', text: 'Move the selected nodes; with Ctrl in large steps' },
  { keys: 'Ctrl ← → ↑ ↓', text: 'Resize a frame or note' },
  { keys: 'Del', text: 'Delete the selection' },
  { keys: 'Shift Del', text: 'Delete and reconnect the neighbours' },
  { keys: 'Ctrl S', text: 'Save the session' },
  { keys: 'Ctrl Enter', text: 'Save and start the session; apply changes while it runs' },
  { keys: 'Ctrl Shift Enter', text: 'Stop the session' },
  { keys: 'W', text: 'Go to the next wire of a node' },
  { keys: 'P', text: 'Add a bend point to a wire' },
  { keys: '[ ]', text: 'Go to the next bend point of a wire' },
  { keys: 'X', text: 'Detach a node from its wires' },
  { keys: 'I', text: 'Insert a node into the wire under it' },
  { keys: 'B', text: 'Bypass a module' },
  { keys: 'M', text: 'Mute a module' },
  { keys: 'C', text: 'Collapse a node' },
  { keys: 'F', text: 'Zoom to fit' },
  { keys: 'Ctrl F', text: 'Find in the graph' },
  { keys: 'Ctrl Z', text: 'Undo' },
  { keys: 'Ctrl Y', text: 'Redo' },
  { keys: 'Ctrl A', text: 'Select all' },
  { keys: 'Ctrl C', text: 'Copy, to this or another session' },
  { keys: 'Ctrl D', text: 'Duplicate' },
  { keys: 'Ctrl G', text: 'Add frame' },
  { keys: 'Alt A D W S', text: 'Align left, right, top, bottom' },
  { keys: '+ −', text: 'Zoom in or out' },
  { keys: 'PgUp PgDn', text: 'Scroll the canvas; with Shift sideways' },
  { keys: 'Space', text: 'and drag: move the canvas' },
  { keys: 'Alt', text: 'and drag: disconnect a node from its wires' },
  { keys: 'Shift', text: 'and drag: select with a box' },
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
