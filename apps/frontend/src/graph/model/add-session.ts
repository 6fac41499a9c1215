import type { Session } from '@ubii/proto';
import type { GraphCommand } from './commands/graph-command.ts';
import type { Graph, GraphNode, Point, Size } from './graph.ts';
import { graphOf } from './graph-of.ts';
import { placeNew } from './layout/place-graph.ts';
import { copyText, paste } from './selection/clipboard.ts';
import { withIds } from './with-ids.ts';

/** Options for adding a session to a graph. */
export interface AddSessionOptions {
  uuid(): string;
  /** Top left of the added nodes. */
  readonly position: Point;
  readonly sizeOf: (node: GraphNode) => Size;
  /** Label of the undo step. */
  readonly label: string;
  /** New name and description of the graph. */
  readonly as?: { readonly name: string; readonly description: string };
}

/** Command that adds a whole session, or the reason why it cannot be added. */
export type AddedSession =
  | { readonly kind: 'added'; readonly command: GraphCommand; readonly ids: readonly string[] }
  | { readonly kind: 'broken'; readonly reason: string };

/** Adds a session to a graph. Modules get new ids; topics stay the same. */
export function addSession(
  graph: Graph,
  session: Session,
  { uuid, position, sizeOf, label, as }: AddSessionOptions,
): AddedSession {
  const added = placeNew(graphOf(withIds(session, uuid)), sizeOf);
  const pasted = paste(graph, copyText(added, added.nodes.keys()), { uuid, position, label });
  if (pasted.kind === 'foreign') {
    return { kind: 'broken', reason: 'The session is too large to be added to a graph.' };
  }
  if (pasted.kind === 'broken') return pasted;
  const commands: GraphCommand[] = [pasted.command];
  if (as !== undefined) commands.push({ kind: 'setDetails', changes: as });
  return { kind: 'added', ids: pasted.ids, command: { kind: 'all', label, commands } };
}
