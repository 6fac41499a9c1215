import { commandLabel } from '../commands/command-label.ts';
import type { GraphCommand } from '../commands/graph-command.ts';
import type { Graph, Point } from '../graph.ts';
import { wiresOf } from '../wires-of.ts';
import type { Places } from './arrange.ts';

/** Returns the wires between these nodes that have bend points, which move along. */
export function pointsGoingAlong(graph: Graph, ids: ReadonlySet<string>): string[] {
  return [...ids].flatMap((id) =>
    wiresOf(graph, id).out.flatMap((wire) =>
      ids.has(wire.to.node) && wire.points.length > 0 ? [wire.id] : [],
    ),
  );
}

/** Moves nodes by the same distance, with the bend points of the wires between them. */
export function moveTogether(graph: Graph, places: Places, by: Point): GraphCommand {
  const move: GraphCommand = { kind: 'move', positions: places };
  const ids = pointsGoingAlong(graph, new Set(places.keys()));
  if (ids.length === 0) return move;
  const reroutes = ids.map((wire): GraphCommand => {
    const points = graph.wires.get(wire)?.points ?? [];
    const moved = points.map(({ x, y }) => ({ x: x + by.x, y: y + by.y }));
    return { kind: 'reroute', wire, points: moved };
  });
  return { kind: 'all', label: commandLabel(graph, move), commands: [move, ...reroutes] };
}
