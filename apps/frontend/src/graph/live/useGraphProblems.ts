import { isSameValue } from '@ubii/proto';
import { computed, provide, type ComputedRef, type InjectionKey } from 'vue';
import { injectOrThrow } from '../../context/inject-or-throw.ts';
import { useConnection } from '../../connection/useConnection.ts';
import type { ModuleLibrary } from '../../modules/library/useModuleLibrary.ts';
import { isAlive } from '../../sessions/state/session-state.ts';
import { runningWriters } from '../../sessions/words/shared-topics.ts';
import { graphProblems, type GraphProblems } from '../model/live/graph-problems.ts';
import type { GraphProblem, TopicAdvice } from '../model/live/graph-problem.ts';
import { isMissing, type Surroundings } from '../model/live/own-problems.ts';
import type { ModuleNode } from '../model/graph.ts';
import { wiresOf } from '../model/wires-of.ts';
import { leftTopicAdvice } from './left-topic-advice.ts';
import { ownTopicRemedy } from './own-topic-remedy.ts';
import { isSilent } from './silent-module.ts';
import type { GraphContext } from './useGraphContext.ts';
import { useOtherTopics } from './useOtherTopics.ts';

/** Problems of the graph, for the views that show them. */
export interface LiveProblems {
  readonly problems: ComputedRef<GraphProblems>;
  ofNode(id: string): readonly GraphProblem[];
  ofPort(node: string, port: string): readonly GraphProblem[];
  ofWire(id: string): readonly GraphProblem[];
  /** True when neither the module nor any node has code for it. */
  isMissing(node: ModuleNode): boolean;
}

const PROBLEMS: InjectionKey<LiveProblems> = Symbol('graph problems');
const NONE: readonly GraphProblem[] = [];

/** Determines the problems of a graph and provides them to child views. */
export function provideGraphProblems(
  { editor, live: values, pad, apply }: GraphContext,
  library: ModuleLibrary,
): LiveProblems {
  const { client, nodes, sessions } = useConnection();
  const openPad = (): void => void (pad.isOpen.value = true);
  const otherTopics = useOtherTopics(editor);
  const remedyOf = (topic: string): TopicAdvice | undefined =>
    ownTopicRemedy(topic, client.id, pad.isOffered.value ? openPad : undefined) ??
    leftTopicAdvice(topic, otherTopics(topic));
  function useOwnTopics(topics: readonly string[]): void {
    const isSaved = editor.changes.value === 0;
    editor.apply({ kind: 'ownTopics', topics });
    // Earlier changes are for the user to apply.
    if (isSaved) apply();
  }
  const around = computed((): Surroundings => {
    const list = nodes.list.value;
    const entries = library.entries.value;
    const offered = (list ?? []).flatMap(({ moduleNames }) => moduleNames);
    const available = (list ?? []).filter((one) => one.available).map((one) => one.clientId);
    return {
      modules: entries && new Set([...entries.map(({ module }) => module.name), ...offered]),
      nodes: list && new Set([...available, client.id]),
      writers: runningWriters(sessions.list.value ?? [], editor.session.value.id),
    };
  });
  /** Lists arrive every few seconds; recompute only when they differ. */
  const settled = computed<Surroundings>((before) =>
    before !== undefined && isSame(before, around.value) ? before : around.value,
  );
  /** Reports arrive continuously; recompute only for other modules. */
  const silent = computed<ReadonlySet<string>>((before) => {
    const modules = [...editor.graph.value.nodes.values()].filter((node) => node.kind === 'module');
    const found = new Set(
      modules
        .filter((node) =>
          isSilent(values.module(node.module.id), wiresOf(editor.graph.value, node.id)),
        )
        .map(({ id }) => id),
    );
    return before !== undefined && isSameSet(before, found) ? before : found;
  });
  const problems = computed(() =>
    graphProblems(editor.graph.value, editor.session.value, {
      ...settled.value,
      remedyOf,
      useOwnTopics,
      isRunning: isAlive(editor.session.value),
      isSilent: ({ id }) => silent.value.has(id),
      isResting: (topic) => pad.isResting(topic),
    }),
  );
  const live: LiveProblems = {
    problems,
    ofNode: (id) => problems.value.ofNode.get(id) ?? NONE,
    ofPort: (node, port) => problems.value.ofPort.get(`${node} ${port}`) ?? NONE,
    ofWire: (id) => problems.value.ofWire.get(id) ?? NONE,
    isMissing: (node) => isMissing(node, settled.value),
  };
  provide(PROBLEMS, live);
  return live;
}

/** For a graph that is only looked at: nothing in it can be corrected. */
export function provideNoProblems(): void {
  const none: GraphProblems = { all: [], ofNode: new Map(), ofPort: new Map(), ofWire: new Map() };
  provide(PROBLEMS, {
    problems: computed(() => none),
    ofNode: () => NONE,
    ofPort: () => NONE,
    ofWire: () => NONE,
    isMissing: () => false,
  });
}

export function useGraphProblems(): LiveProblems {
  return injectOrThrow(PROBLEMS, 'the graph page above it');
}

const isSame = (a: Surroundings, b: Surroundings): boolean =>
  isSameSet(a.modules, b.modules) &&
  isSameSet(a.nodes, b.nodes) &&
  isSameValue([...a.writers], [...b.writers]);

function isSameSet(
  a: ReadonlySet<string> | undefined,
  b: ReadonlySet<string> | undefined,
): boolean {
  if (a === undefined || b === undefined) return a === b;
  return a.size === b.size && [...a].every((one) => b.has(one));
}
