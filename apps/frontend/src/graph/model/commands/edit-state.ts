import type { Graph } from '../graph.ts';
import { applyCommand } from './apply-command.ts';
import type { GraphCommand } from './graph-command.ts';
import { GraphEdit, isEmptyPatch, type GraphPatch } from './graph-edit.ts';

/** One thing a person did, in words, with the ways back and there again. */
export interface Step {
  readonly label: string;
  /** Steps with the same key that follow each other are one: the parts of a drag, letters typed. */
  readonly key: string | undefined;
  readonly undo: GraphPatch;
  readonly redo: GraphPatch;
}

/** A graph being edited, and how it came to be. Never changed: each step makes a new one. */
export interface EditState {
  readonly graph: Graph;
  /** Oldest first. */
  readonly past: readonly Step[];
  /** What can be done again, next one last. */
  readonly future: readonly Step[];
}

/** Steps that are kept. */
export const MAX_STEPS = 500;

export function startEditing(graph: Graph): EditState {
  return { graph, past: [], future: [] };
}

/**
 * Does a command, as a step that can be undone. Nothing happens when it would change nothing.
 * @param key the same for all commands of one drag
 */
export function perform(state: EditState, command: GraphCommand, key?: string): EditState {
  const { graph, inverse, redo } = applyCommand(state.graph, command);
  if (graph === state.graph || (isEmptyPatch(redo) && isEmptyPatch(inverse.patch))) return state;
  const step: Step = { label: inverse.label, key, undo: inverse.patch, redo };
  const last = state.past.at(-1);
  const past =
    last !== undefined && key !== undefined && last.key === key
      ? [...state.past.slice(0, -1), joined(last, step)]
      : [...state.past, step].slice(-MAX_STEPS);
  return { graph, past, future: [] };
}

/** Ends a drag: what comes next with the same key is a step of its own. */
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

/** Two steps as one: the older one says what was, the newer one what is. */
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
