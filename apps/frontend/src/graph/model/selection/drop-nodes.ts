import { applyCommand } from '../commands/apply-command.ts';
import { commandLabel } from '../commands/command-label.ts';
import type { GraphCommand } from '../commands/graph-command.ts';
import type { Graph, Point } from '../graph.ts';
import type { Box } from './arrange.ts';
import { frameChanges } from './frames.ts';
import { insertOnWire } from './insert.ts';
import { moveTogether } from './move.ts';
import { detach } from './reconnect.ts';

/** Position on a wire. */
export interface InsertPlace {
  readonly wire: string;
  /** Number of the wire's bend points before this position. */
  readonly leg: number;
}

/** Result of dragging nodes. */
export interface NodeDrop {
  /** Final boxes of all moved nodes. */
  readonly boxes: readonly Box[];
  /** Final boxes of all frames. */
  readonly frames: readonly Box[];
  readonly by: Point;
  /** True when their wires were disconnected during the drag. */
  readonly isDetached: boolean;
  /** Position on the wire that a single node was dropped on. */
  readonly on: InsertPlace | undefined;
  /** Drawn boxes of all nodes; after insertion into a wire, nodes downstream move aside. */
  readonly others?: readonly Box[];
}

/** Returns all changes of a drag as one step. */
export function dropNodes(graph: Graph, drop: NodeDrop): GraphCommand {
  const { boxes, frames, by, isDetached, on } = drop;
  const moved = new Set(boxes.map(({ id }) => id));
  const free = isDetached ? [detach(graph, [...moved])] : [];
  const rest = free.reduce((before, command) => applyCommand(before, command).graph, graph);
  const places = new Map(boxes.map(({ id, x, y }) => [id, { x, y }]));
  const [only] = boxes;
  const node = only && rest.nodes.get(only.id);
  const around = drop.others === undefined || only === undefined ? [] : [...drop.others, only];
  const insert = on && node && insertOnWire(rest, on.wire, node, on.leg, around);
  // Nodes that moved with their frame stay in it.
  const loose = boxes.filter(({ id }) => {
    const frame = rest.nodes.get(id)?.frame;
    return frame === undefined || !moved.has(frame);
  });
  const joined = frameChanges(rest, loose, frames);
  const said = [...(insert ? [insert] : []), ...free, ...joined];
  const move = moveTogether(rest, places, by);
  return {
    kind: 'all',
    label: commandLabel(graph, said[0] ?? move),
    commands: [...free, move, ...(insert ? [insert] : []), ...joined],
  };
}
