/** Row of the dialog with the keyboard shortcuts. Only that dialog loads these tables. */
export interface KeyText {
  readonly keys: string;
  readonly text: string;
}

/** Keys of one place, under the heading of the place. */
export interface KeyGroup {
  readonly title: string;
  readonly keys: readonly KeyText[];
}

/** Keys on the focused row of a list. The lists handle them. */
const ROW_KEYS: readonly KeyText[] = [
  { keys: '↑ ↓', text: 'Move between rows' },
  { keys: 'Enter', text: 'Open the row' },
  { keys: 'Space', text: 'Start, pause or resume a session' },
  { keys: 'F2', text: 'Rename a session or a client' },
  { keys: 'Del', text: 'Delete a session or a stored module, disconnect a client' },
];

/** Keys on Home. `home/back/RunningCards.vue` handles them. */
const HOME_KEYS: readonly KeyText[] = [{ keys: '1 … 9', text: 'Open a session that runs' }];

/** Keys of an opened recording. `recordings/view/useTimelineKeys.ts` handles them. */
const RECORDING_KEYS: readonly KeyText[] = [
  { keys: 'Space', text: 'Play or pause' },
  { keys: '← →', text: 'Go to the previous or next record of the selected track' },
  { keys: 'Shift ← →', text: 'Go back or forward by 1 s' },
  { keys: ', .', text: 'Go to the previous or next picture' },
  { keys: 'I O', text: 'Start or end the loop at the playhead' },
  { keys: 'M', text: 'Add a marker at the playhead' },
  { keys: '0', text: 'Show all of the recording' },
  { keys: 'Shift', text: 'and drag: loop what is marked' },
];

/** Keys on Panels. `topics/panels/PanelsPage.vue`, `useWholeWindow.ts` and the plots handle them. */
const PANEL_KEYS: readonly KeyText[] = [
  { keys: 'F', text: 'Start or end full screen' },
  { keys: 'Ctrl Z', text: 'Undo' },
  { keys: 'Ctrl Y', text: 'Redo' },
  { keys: '← →', text: 'Move the reading line of a plot; with Shift its time' },
  { keys: '+ −', text: 'Zoom a plot in or out' },
  { keys: 'A B', text: 'Set a cursor at the reading line' },
];

/** Keys on the canvas of a graph. `graph/canvas/canvas-keys.ts` handles them. */
export const GRAPH_KEYS: readonly KeyText[] = [
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
  { keys: 'P', text: 'Show the next problem' },
  { keys: 'R', text: 'Add a bend point to a wire' },
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
  { keys: 'Space', text: 'Pause the values on the canvas; while held, drag to move the canvas' },
  { keys: 'Alt', text: 'and drag: disconnect a node from its wires' },
  { keys: 'Shift', text: 'and drag: select with a box' },
];

const PLACES: readonly (KeyGroup & { readonly path: RegExp })[] = [
  { title: 'On Home', keys: HOME_KEYS, path: /^\/$/ },
  {
    title: 'On a row of Sessions, Modules or Clients',
    keys: ROW_KEYS,
    path: /^\/(sessions|modules|clients)$/,
  },
  { title: 'In the graph of a session', keys: GRAPH_KEYS, path: /^\/sessions\/./ },
  { title: 'On Panels', keys: PANEL_KEYS, path: /^\/panels/ },
  { title: 'In a recording', keys: RECORDING_KEYS, path: /^\/recordings/ },
];

/** Returns the groups of the dialog with the keyboard shortcuts: those of the page at `path` first. */
export function keyGroups(path: string, everywhere: readonly KeyText[]): readonly KeyGroup[] {
  const isHere = (place: (typeof PLACES)[number]): boolean => place.path.test(path);
  return [
    ...PLACES.filter(isHere),
    { title: 'Everywhere', keys: everywhere },
    ...PLACES.filter((place) => !isHere(place)),
  ];
}
