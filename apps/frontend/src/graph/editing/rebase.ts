import { isSameValue } from '@ubii/proto';
import { mergeGraphs } from '../model/changes/merge-graphs.ts';
import type { Conflict } from '../model/changes/conflict.ts';
import { perform, startEditing, type EditState } from '../model/commands/edit-state.ts';
import type { GraphPatch } from '../model/commands/graph-edit.ts';
import type { Graph } from '../model/graph.ts';

/** Result of applying the user's changes to the version that another user saved. */
export interface Rebased {
  readonly state: EditState;
  readonly conflicts: readonly Conflict[];
}

/** Applies the changes from `base` to `mine` as one step on `theirs`. */
export function rebase(base: Graph, mine: Graph, theirs: Graph): Rebased {
  const { graph, conflicts } = mergeGraphs(base, mine, theirs);
  const patch = patchBetween(theirs, graph);
  const label = 'Your earlier changes';
  const state = perform(startEditing(theirs), { kind: 'patch', patch, label });
  return { state, conflicts };
}

/** Returns the patch that makes the one graph the other. */
export function patchBetween(from: Graph, to: Graph): GraphPatch {
  return {
    nodes: differing(from.nodes, to.nodes),
    wires: differing(from.wires, to.wires),
    details: isSameValue(to.details, from.details) ? undefined : to.details,
  };
}

function differing<T>(
  from: ReadonlyMap<string, T>,
  to: ReadonlyMap<string, T>,
): ReadonlyMap<string, T | undefined> {
  const ids = new Set([...from.keys(), ...to.keys()]);
  return new Map(
    [...ids].filter((id) => from.get(id) !== to.get(id)).map((id) => [id, to.get(id)]),
  );
}
