import type { GraphCommand } from '../../model/commands/graph-command.ts';
import type { Graph, GraphNode } from '../../model/graph.ts';
import {
  align,
  distribute,
  type Alignment,
  type Box,
  type Places,
} from '../../model/selection/arrange.ts';
import { frameAround } from '../../model/selection/frames.ts';
import { frameLeft } from '../../model/nesting.ts';
import { action, type MenuAction, type MenuEntry, type MenuPlace } from './menu-entry.ts';

const ALIGNMENTS: readonly (readonly [Alignment, text: string, shortcut: string])[] = [
  ['left', 'Left edges', 'Alt A'],
  ['center', 'Centres', 'Alt H'],
  ['right', 'Right edges', 'Alt D'],
  ['top', 'Top edges', 'Alt W'],
  ['middle', 'Middles', 'Alt V'],
  ['bottom', 'Bottom edges', 'Alt S'],
];

/** Returns the entries that frame and align nodes. */
export function lineUpMenu(
  graph: Graph,
  nodes: readonly GraphNode[],
  { boxOf, uuid }: MenuPlace,
): MenuEntry[] {
  const boxes: Box[] = nodes.flatMap(({ id }) => {
    const box = boxOf(id);
    return box === undefined ? [] : [{ id, ...box }];
  });
  const framed = nodes.filter(({ frame }) => frame !== undefined && graph.nodes.has(frame));
  const frame = `frame:${uuid()}`;
  return [
    ...(boxes.length === 0
      ? []
      : [
          action(
            'Add frame',
            { command: frameAround(graph, boxes, frame), select: [frame] },
            { shortcut: 'Ctrl G' },
          ),
        ]),
    ...(framed.length === 0
      ? []
      : [action('Remove from frame', { command: takeOut(graph, framed) })]),
    ...(boxes.length > 1 ? [{ kind: 'group', text: 'Align', entries: lines(boxes) } as const] : []),
  ];
}

/** Moves nodes out of their frame into the frame around it, if any. */
function takeOut({ nodes: all }: Graph, nodes: readonly GraphNode[]): GraphCommand {
  const commands = nodes.map(({ id, frame = '' }): GraphCommand => {
    return { kind: 'setFrame', nodes: [id], frame: frameLeft(all, id, new Set([frame])) };
  });
  const [only] = commands;
  if (only !== undefined && commands.length === 1) return only;
  return { kind: 'all', label: `Remove ${commands.length} nodes from their frames`, commands };
}

function lines(boxes: readonly Box[]): MenuAction[] {
  // Store a position for all nodes: the layout would move nodes without one around the others.
  const move = (places: Places): GraphCommand => ({
    kind: 'move',
    positions: new Map([...boxes.map(({ id, x, y }) => [id, { x, y }] as const), ...places]),
  });
  return [
    ...ALIGNMENTS.map(([alignment, text, shortcut]) =>
      action(text, { command: move(align(boxes, alignment)) }, { shortcut }),
    ),
    ...(boxes.length > 2
      ? [
          action(
            'Distribute horizontally',
            { command: move(distribute(boxes, 'x')) },
            { shortcut: 'Alt Shift H' },
          ),
          action(
            'Distribute vertically',
            { command: move(distribute(boxes, 'y')) },
            { shortcut: 'Alt Shift V' },
          ),
        ]
      : []),
  ];
}
