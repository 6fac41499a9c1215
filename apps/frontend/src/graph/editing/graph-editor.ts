import { isSameValue, type Session } from '@ubii/proto';
import { computed, shallowRef, type ComputedRef, type ShallowRef } from 'vue';
import { applyCommand } from '../model/commands/apply-command.ts';
import {
  perform,
  redo,
  seal,
  startEditing,
  undo,
  type EditState,
} from '../model/commands/edit-state.ts';
import type { GraphCommand } from '../model/commands/graph-command.ts';
import { nothingElsewhere } from '../model/commands/topics-elsewhere.ts';
import { graphOf } from '../model/graph-of.ts';
import type { Graph, GraphNode, Point } from '../model/graph.ts';
import { sessionOf } from '../model/session-of.ts';
import { keepEditorData } from '../model/changes/keep-editor-data.ts';
import type { Conflict } from '../model/changes/conflict.ts';
import { graphNews, type GraphNews } from '../model/changes/graph-news.ts';
import { withIds } from '../model/with-ids.ts';
import { placesOf } from './places.ts';
import { patchBetween, rebase } from './rebase.ts';
import { isSameGraph } from './same-graph.ts';

/** Selected nodes, or the selected wire. */
export interface Selection {
  readonly nodes: ReadonlySet<string>;
  readonly wire: string | undefined;
}

/** Graph at the time of a save. */
export interface Saved {
  readonly graph: Graph;
  readonly steps: number;
}

/** The newest save of another client. */
export interface News {
  readonly revision: number;
  readonly changes: readonly GraphNews[];
}

/** A session being edited as a graph. All edits go through `apply`. */
export interface GraphEditor {
  /** Session as stored on the master: its status, problems and last saved content. */
  readonly session: Readonly<ShallowRef<Session>>;
  readonly graph: ComputedRef<Graph>;
  /** Positions of all nodes, also of nodes without a stored one. */
  readonly places: ComputedRef<ReadonlyMap<string, Point>>;
  readonly selection: ShallowRef<Selection>;
  /** Number of steps since the session was saved. */
  readonly changes: ComputedRef<number>;
  /** Returns a node as the master has it; undefined if it does not have the node. */
  savedNode(id: string): GraphNode | undefined;
  /** Whether a new name of the session, with the topics that follow it, is the only unsaved change. */
  isOnlyRenamed(): boolean;
  /** Label of the step that undo reverts; undefined when there is none. */
  readonly undoLabel: ComputedRef<string | undefined>;
  readonly redoLabel: ComputedRef<string | undefined>;
  /** Conflicts after another client saved the session while it had unsaved changes here. */
  readonly merged: Readonly<ShallowRef<readonly Conflict[] | undefined>>;
  /** The last save of another client, until the notice is dismissed. */
  readonly news: Readonly<ShallowRef<News | undefined>>;
  /** @param key equal for commands that form one undo step: movements of a drag, typed letters */
  apply(command: GraphCommand, key?: string): void;
  /** Ends the current undo step. */
  seal(): void;
  undo(): void;
  redo(): void;
  select(nodes: Iterable<string>): void;
  selectWire(wire: string): void;
  /**
   * Handles a session as the master announced it.
   * @param isReopened the master was restarted: its revision may be lower than before
   */
  handleSession(session: Session, isReopened?: boolean): void;
  /**
   * Delays announcements while a save is under way: its announcement may arrive before its reply.
   * @param sent session that is being saved; recognised when only its announcement arrives
   * @returns a function that ends the delay
   */
  hold(sent: Session): () => void;
  /** Recognises a save that this page sent before a reload. */
  expect(sent: Session): void;
  /** Returns the session to save, with all nodes at their current positions. */
  toSession(): Session;
  /** Returns the current state, for `handleSaved`. */
  mark(): Saved;
  /** Handles a successful save of the state at the mark. */
  handleSaved(session: Session, mark: Saved): void;
  /** Shows a session that this page saved as a text, as one step of undo. */
  adopt(session: Session): void;
  /** Resolves a conflict with the other client's change. */
  takeTheirs(conflict: Conflict): void;
  /** Resolves a conflict with the user's own change. */
  takeMine(conflict: Conflict): void;
  /** Dismisses the notice about a merge. */
  dismissMerge(): void;
  /** Returns the session that the unsaved changes are based on, to keep both versions. */
  baseSession(): Session;
  /** Restores earlier unsaved changes, on top of the session they were based on. */
  resume(before: Session, edited: Session): void;
}

const NOTHING: Selection = { nodes: new Set(), wire: undefined };
const revisionOf = ({ extension }: Session): number => extension?.revision ?? 0;

/**
 * @param uuid returns a new UUID
 * @param elsewhere returns the topics that others use, which new wires avoid
 */
export function createGraphEditor(
  first: Session,
  uuid: () => string,
  elsewhere = nothingElsewhere,
): GraphEditor {
  const session = shallowRef(first);
  /** Session that the graph was built from. */
  let base = withIds(first, uuid);
  const state = shallowRef(startEditing(graphOf(base)));
  const graph = computed(() => state.value.graph);
  const selection = shallowRef<Selection>(NOTHING);
  /** Last saved state. */
  const saved = shallowRef({ graph: graph.value, steps: 0 });
  const merged = shallowRef<readonly Conflict[]>();
  const news = shallowRef<News>();
  const changes = computed(() => {
    if (isSameGraph(graph.value, saved.value.graph)) return 0;
    return Math.max(1, Math.abs(state.value.past.length - saved.value.steps));
  });

  function show(next: EditState): void {
    state.value = next;
    const { nodes, wire } = selection.value;
    const kept = [...nodes].filter((id) => next.graph.nodes.has(id));
    const isWireGone = wire !== undefined && !next.graph.wires.has(wire);
    if (kept.length === nodes.size && !isWireGone) return;
    selection.value = { nodes: new Set(kept), wire: isWireGone ? undefined : wire };
  }

  function reset(next: Session): void {
    base = withIds(keepEditorData(next, base), uuid);
    session.value = next;
    merged.value = undefined;
    show(startEditing(graphOf(base)));
    saved.value = { graph: graph.value, steps: 0 };
  }

  function settle(conflict: Conflict): void {
    merged.value = merged.value?.filter((other) => other !== conflict);
  }

  /** Reapplies the local changes to the master's version. */
  function rebaseOn(next: Session, before: Graph, mine: Graph): void {
    base = withIds(keepEditorData(next, base), uuid);
    session.value = next;
    const theirs = graphOf(base);
    const { state: rebased, conflicts } = rebase(before, mine, theirs);
    saved.value = { graph: theirs, steps: 0 };
    show(rebased);
    merged.value = conflicts;
  }

  /** Newest save without a reply, with the state it holds; without `mark` when an earlier page sent it. */
  let sent: { readonly session: Session; readonly mark?: Saved } | undefined;
  const mark = (): Saved => ({ graph: graph.value, steps: state.value.past.length });

  /** Whether the graph equals the last one sent: a reply can be lost with the connection or by a reload. */
  const isSent = (theirs: Graph): boolean =>
    sent !== undefined && graphNews(graphOf(withIds(sent.session, uuid)), theirs).length === 0;

  function handleSent(next: Session): void {
    const { mark: steps } = sent!;
    sent = undefined;
    if (steps !== undefined) {
      base = withIds(keepEditorData(next, base), uuid);
      session.value = next;
      merged.value = undefined;
      saved.value = steps;
    } else if (changes.value === 0) {
      reset(next);
    } else {
      rebaseOn(next, graphOf(base), graph.value);
      if (merged.value?.length === 0) merged.value = undefined;
    }
  }

  let holds = 0;
  let held: { readonly session: Session; readonly isReopened: boolean } | undefined;

  function hear(next: Session, isReopened = false): void {
    if (!isReopened && revisionOf(next) <= revisionOf(base)) {
      session.value = next;
      return;
    }
    const before = graphOf(base);
    const kept = withIds(keepEditorData(next, base), uuid);
    const theirs = graphOf(kept);
    const said = graphNews(before, theirs);
    if (said.length > 0 && isSent(theirs)) {
      handleSent(next);
      return;
    }
    if (said.length === 0) {
      // Only the status, or nodes chosen by the master, changed: undo steps stay valid.
      base = kept;
      session.value = next;
      return;
    }
    if (changes.value === 0) reset(next);
    else rebaseOn(next, before, graph.value);
    news.value = { revision: revisionOf(next), changes: said };
  }

  return {
    session,
    graph,
    places: computed(() => placesOf(graph.value)),
    selection,
    changes,
    savedNode: (id) => saved.value.graph.nodes.get(id),
    isOnlyRenamed() {
      const { graph: before } = saved.value;
      const { name } = graph.value.details;
      if (name === before.details.name) return false;
      // The topics of wires follow the name.
      const rename = { kind: 'setDetails', changes: { name } } as const;
      return isSameValue(applyCommand(before, rename, elsewhere).graph, graph.value);
    },
    undoLabel: computed(() => state.value.past.at(-1)?.label),
    redoLabel: computed(() => state.value.future.at(-1)?.label),
    merged,
    news,
    apply: (command, key) => show(perform(state.value, command, key, elsewhere)),
    seal: () => (state.value = seal(state.value)),
    undo: () => show(undo(state.value)),
    redo: () => show(redo(state.value)),
    select(nodes) {
      selection.value = { nodes: new Set(nodes), wire: undefined };
    },
    selectWire(wire) {
      selection.value = { nodes: new Set(), wire };
    },
    handleSession(next, isReopened = false) {
      if (holds > 0) held = { session: next, isReopened: isReopened || held?.isReopened === true };
      else hear(next, isReopened);
    },
    expect: (earlier) => (sent = { session: earlier }),
    hold(next) {
      sent = { session: next, mark: mark() };
      holds += 1;
      return () => {
        holds -= 1;
        const waiting = held;
        if (holds > 0 || waiting === undefined) return;
        held = undefined;
        hear(waiting.session, waiting.isReopened);
      };
    },
    toSession() {
      const positions = placesOf(graph.value);
      return sessionOf(applyCommand(graph.value, { kind: 'move', positions }).graph, base);
    },
    handleSaved(next, stored) {
      sent = undefined;
      if (revisionOf(next) > 0 && revisionOf(next) === revisionOf(base)) {
        // The announcement came before the reply: the local changes are already based on it.
        if (merged.value?.length === 0) merged.value = undefined;
        return;
      }
      base = next;
      session.value = next;
      merged.value = undefined;
      saved.value = stored;
    },
    adopt(next) {
      sent = undefined;
      base = withIds(keepEditorData(next, base), uuid);
      session.value = next;
      merged.value = undefined;
      const patch = patchBetween(graph.value, graphOf(base));
      show(perform(seal(state.value), { kind: 'patch', patch, label: 'Apply JSON' }));
      saved.value = mark();
    },
    mark,
    takeTheirs(conflict) {
      show(perform(state.value, conflict.takeTheirs));
      settle(conflict);
    },
    takeMine(conflict) {
      if (conflict.takeMine !== undefined) show(perform(state.value, conflict.takeMine));
      settle(conflict);
    },
    dismissMerge() {
      merged.value = undefined;
      news.value = undefined;
    },
    baseSession: () => base,
    resume(before, edited) {
      rebaseOn(session.value, graphOf(before), graphOf(edited));
      if (merged.value?.length === 0) merged.value = undefined;
    },
  };
}
