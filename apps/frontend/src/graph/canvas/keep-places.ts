import type { GraphCommand } from '../model/commands/graph-command.ts';
import type { Graph, Point } from '../model/graph.ts';

/**
 * Returns the command that stores the drawn position of nodes without a stored one; `undefined` when all have one.
 * Without it, a node that is added with a position would make the layout put them below it.
 *
 * @param positions drawn positions of nodes
 */
export function keepPlaces(
  { nodes }: Pick<Graph, 'nodes'>,
  positions: ReadonlyMap<string, Point>,
): Extract<GraphCommand, { kind: 'move' }> | undefined {
  const kept = [...nodes.values()].flatMap(({ id, position }) => {
    const drawn = positions.get(id);
    return position === undefined && drawn !== undefined ? [[id, drawn] as const] : [];
  });
  return kept.length === 0 ? undefined : { kind: 'move', positions: new Map(kept) };
}
