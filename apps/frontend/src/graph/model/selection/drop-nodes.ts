import { applyCommand } from '../commands/apply-command.ts';
import { commandLabel } from '../commands/command-label.ts';
import type { GraphCommand } from '../commands/graph-command.ts';
import type { Graph, Point } from '../graph.ts';
import type { Box } from './arrange.ts';
import { frameChanges } from './frames.ts';
import { insertOnWire } from './insert.ts';
import { moveTogether } from './move.ts';
import { detach } from './reconnect.ts';

/** A place on a wire. */
export interface InsertPlace {
  readonly wire: string;
  /** How many of the points of the wire come before it. */
  readonly leg: number;
}

/** What became of nodes that were dragged. */
export interface NodeDrop {
  /** All that were moved, as they lie now. */
  readonly boxes: readonly Box[];
  /** All frames, as they lie now. */
  readonly frames: readonly Box[];
  readonly by: Point;
  /** Their wires came off on the way. */
  readonly isDetached: boolean;
  /** Where it was dropped on a wire, when it was one node. */
  readonly on: InsertPlace | undefined;
  /** All nodes as they are drawn: on a wire, nodes downstream move aside. */
  readonly others?: readonly Box[];
}

/** All that a drag did, as one step. */
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
  // What moved with its frame stays in it.
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
