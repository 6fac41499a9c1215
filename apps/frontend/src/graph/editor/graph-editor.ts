import type { Session } from '@ubii/proto';
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
import { graphOf } from '../model/graph-of.ts';
import type { Graph, Point } from '../model/graph.ts';
import { sessionOf } from '../model/session-of.ts';
import { keepEditorData } from '../model/changes/keep-editor-data.ts';
import type { Conflict } from '../model/changes/conflict.ts';
import { graphNews, type GraphNews } from '../model/changes/graph-news.ts';
import { withIds } from '../model/with-ids.ts';
import { placesOf } from './places.ts';
import { rebase } from './rebase.ts';
import { isSameGraph } from './same-graph.ts';

/** What is selected: nodes, or one wire. */
export interface Selection {
  readonly nodes: ReadonlySet<string>;
  readonly wire: string | undefined;
}

/** A graph as it was at some moment. */
export interface Saved {
  readonly graph: Graph;
  readonly steps: number;
}

/** What somebody else saved. */
export interface News {
  readonly revision: number;
  readonly changes: readonly GraphNews[];
}

/** A session being edited as a graph. Everything people do to it goes through `apply`. */
export interface GraphEditor {
  /** As the master has it: its life, problems and what was saved last. */
  readonly session: Readonly<ShallowRef<Session>>;
  readonly graph: ComputedRef<Graph>;
  /** Where every node stands, also those that nobody has placed yet. */
  readonly places: ComputedRef<ReadonlyMap<string, Point>>;
  readonly selection: ShallowRef<Selection>;
  /** Steps made since the session was saved. */
  readonly changes: ComputedRef<number>;
  /** What the next undo takes back, in words; undefined when there is nothing. */
  readonly undoLabel: ComputedRef<string | undefined>;
  readonly redoLabel: ComputedRef<string | undefined>;
  /** Somebody else saved the session while there were changes here: what both changed. */
  readonly merged: Readonly<ShallowRef<readonly Conflict[] | undefined>>;
  /** What somebody else saved last, until it was read. */
  readonly news: Readonly<ShallowRef<News | undefined>>;
  /** @param key the same for all commands that are one step: the parts of a drag, letters typed */
  apply(command: GraphCommand, key?: string): void;
  /** Ends such a step. */
  seal(): void;
  undo(): void;
  redo(): void;
  select(nodes: Iterable<string>): void;
  selectWire(wire: string): void;
  /** Hears what the master has now. */
  handleSession(session: Session): void;
  /**
   * Lets what the master tells wait while a save is on its way: the news of it may come before its
   * answer, and is nobody else's.
   * @returns what ends that
   */
  hold(): () => void;
  /** Puts down everything as it was arranged now: for saving. */
  toSession(): Session;
  /** What there is to save now, to be told when it was. */
  mark(): Saved;
  /** The master has what was there at the mark. */
  handleSaved(session: Session, mark: Saved): void;
  /** Does it the way of the others. */
  takeTheirs(conflict: Conflict): void;
  /** Leaves it as it is here, or brings it back to that. */
  takeMine(conflict: Conflict): void;
  /** What was merged was read. */
  dismissMerge(): void;
  /** What the changes began with, for keeping both. */
  baseSession(): Session;
  /** Takes up changes that were made before, to a session as it was then. */
  resume(before: Session, edited: Session): void;
}

const NOTHING: Selection = { nodes: new Set(), wire: undefined };
const revisionOf = ({ extension }: Session): number => extension?.revision ?? 0;

/** @param uuid gives a new UUID */
export function createGraphEditor(first: Session, uuid: () => string): GraphEditor {
  const session = shallowRef(first);
  /** What the graph was made of. */
  let base = withIds(first, uuid);
  const state = shallowRef(startEditing(graphOf(base)));
  const graph = computed(() => state.value.graph);
  const selection = shallowRef<Selection>(NOTHING);
  /** What is saved. */
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

  /** Puts changes on top of what the master has now. */
  function rebaseOn(next: Session, before: Graph, mine: Graph): void {
    base = withIds(keepEditorData(next, base), uuid);
    session.value = next;
    const theirs = graphOf(base);
    const { state: rebased, conflicts } = rebase(before, mine, theirs);
    saved.value = { graph: theirs, steps: 0 };
    show(rebased);
    merged.value = conflicts;
  }

  let holds = 0;
  let held: Session | undefined;

  function hear(next: Session): void {
    if (revisionOf(next) <= revisionOf(base)) {
      session.value = next;
      return;
    }
    const before = graphOf(base);
    const kept = withIds(keepEditorData(next, base), uuid);
    const said = graphNews(before, graphOf(kept));
    if (said.length === 0) {
      // How it lives, or where the master put what: nothing to undo is lost by that.
      base = kept;
      session.value = next;
      return;
    }
    if (changes.value === 0) reset(next);
    else rebaseOn(next, before, graph.value);
    news.value = said.length === 0 ? undefined : { revision: revisionOf(next), changes: said };
  }

  return {
    session,
    graph,
    places: computed(() => placesOf(graph.value)),
    selection,
    changes,
    undoLabel: computed(() => state.value.past.at(-1)?.label),
    redoLabel: computed(() => state.value.future.at(-1)?.label),
    merged,
    news,
    apply: (command, key) => show(perform(state.value, command, key)),
    seal: () => (state.value = seal(state.value)),
    undo: () => show(undo(state.value)),
    redo: () => show(redo(state.value)),
    select(nodes) {
      selection.value = { nodes: new Set(nodes), wire: undefined };
    },
    selectWire(wire) {
      selection.value = { nodes: new Set(), wire };
    },
    handleSession(next) {
      if (holds > 0) held = next;
      else hear(next);
    },
    hold() {
      holds += 1;
      return () => {
        holds -= 1;
        const next = held;
        if (holds > 0 || next === undefined) return;
        held = undefined;
        hear(next);
      };
    },
    toSession() {
      const positions = placesOf(graph.value);
      return sessionOf(applyCommand(graph.value, { kind: 'move', positions }).graph, base);
    },
    handleSaved(next, sent) {
      if (revisionOf(next) > 0 && revisionOf(next) === revisionOf(base)) {
        // The news of it came first: what is here stands on top of it already.
        if (merged.value?.length === 0) merged.value = undefined;
        return;
      }
      base = next;
      session.value = next;
      merged.value = undefined;
      saved.value = sent;
    },
    mark: () => ({ graph: graph.value, steps: state.value.past.length }),
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
