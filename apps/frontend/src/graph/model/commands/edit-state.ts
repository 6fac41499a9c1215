import type { Graph } from '../graph.ts';
import { applyCommand } from './apply-command.ts';
import type { GraphCommand } from './graph-command.ts';
import { GraphEdit, isEmptyPatch, type GraphPatch } from './graph-edit.ts';
import { nothingElsewhere } from './topics-elsewhere.ts';

/** One step of the history, with its label, and the patches for undo and redo. */
export interface Step {
  readonly label: string;
  /** Consecutive steps with the same key are one: movements of a drag, typed letters. */
  readonly key: string | undefined;
  readonly undo: GraphPatch;
  readonly redo: GraphPatch;
}

/** A graph with its history. Immutable: each step returns a new state. */
export interface EditState {
  readonly graph: Graph;
  /** Oldest first. */
  readonly past: readonly Step[];
  /** Steps that can be redone, next one last. */
  readonly future: readonly Step[];
}

/** Most steps kept. */
export const MAX_STEPS = 500;

export function startEditing(graph: Graph): EditState {
  return { graph, past: [], future: [] };
}

/**
 * Applies a command as a step that can be undone. Does nothing if the command changes nothing.
 * @param key equal for all commands of one drag
 * @param elsewhere returns the topics that others use
 */
export function perform(
  state: EditState,
  command: GraphCommand,
  key?: string,
  elsewhere = nothingElsewhere,
): EditState {
  const { graph, inverse, redo } = applyCommand(state.graph, command, elsewhere);
  if (graph === state.graph || (isEmptyPatch(redo) && isEmptyPatch(inverse.patch))) return state;
  const step: Step = { label: inverse.label, key, undo: inverse.patch, redo };
  const last = state.past.at(-1);
  const past =
    last !== undefined && key !== undefined && last.key === key
      ? [...state.past.slice(0, -1), joined(last, step)]
      : [...state.past, step].slice(-MAX_STEPS);
  return { graph, past, future: [] };
}

/** Ends a drag: a next command with the same key is a new step. */
export function seal(state: EditState): EditState {
  const last = state.past.at(-1);
  if (last?.key === undefined) return state;
  return { ...state, past: [...state.past.slice(0, -1), { ...last, key: undefined }] };
}

export function undo(state: EditState): EditState {
  const step = state.past.at(-1);
  if (step === undefined) return state;
  return {
    graph: patched(state.graph, step.undo),
    past: state.past.slice(0, -1),
    future: [...state.future, { ...step, key: undefined }],
  };
}

export function redo(state: EditState): EditState {
  const step = state.future.at(-1);
  if (step === undefined) return state;
  return {
    graph: patched(state.graph, step.redo),
    past: [...state.past, step],
    future: state.future.slice(0, -1),
  };
}

function patched(graph: Graph, patch: GraphPatch): Graph {
  const edit = new GraphEdit(graph);
  edit.apply(patch);
  return edit.graph;
}

/** Joins two steps: undo patch of the older one, redo patch of the newer one. */
function joined(older: Step, newer: Step): Step {
  return {
    ...older,
    label: newer.label,
    undo: overlaid(newer.undo, older.undo),
    redo: overlaid(older.redo, newer.redo),
  };
}

function overlaid(below: GraphPatch, above: GraphPatch): GraphPatch {
  return {
    nodes: new Map([...below.nodes, ...above.nodes]),
    wires: new Map([...below.wires, ...above.wires]),
    details: above.details ?? below.details,
  };
}
