import { plural } from '@ubii/words';

import { fitOf } from '../fit/fit-of.ts';
import type { Graph, ModuleNode } from '../graph.ts';
import { wiresOf } from '../wires-of.ts';
import { cyclesIn } from './cycles.ts';
import type { GraphProblem, TopicAdvice } from './graph-problem.ts';
import { moduleFaults, type RunState } from './module-faults.ts';
import { writtenElsewhere, type OtherWriters, type UseOwnTopics } from './other-sessions.ts';

/** Known modules and nodes; undefined while unknown. */
export interface Surroundings extends RunState {
  /** Names of modules that the library or a node offers. */
  readonly modules: ReadonlySet<string> | undefined;
  /** Ids of nodes that can run modules now. */
  readonly nodes: ReadonlySet<string> | undefined;
  /** Topics that other running sessions write. */
  readonly writers: OtherWriters;
  /** Replaces topics that other sessions write by own ones. */
  readonly useOwnTopics?: UseOwnTopics;
  /** Returns advice about a topic without a value. */
  readonly remedyOf?: (topic: string) => TopicAdvice | undefined;
  /** Whether a topic has no value only because the pad is not touched, which is no problem. */
  readonly isResting?: (topic: string) => boolean;
}

/** Returns the problems that the editor detects before saving. */
export function ownProblems(graph: Graph, around: Surroundings): GraphProblem[] {
  return [
    ...misfits(graph),
    ...moduleProblems(graph, around),
    ...moduleFaults(graph, around),
    ...doubleWriters(graph),
    ...writtenElsewhere(graph, around.writers, around.useOwnTopics),
    ...cycles(graph),
  ];
}

/** True when no code exists for a module. */
export function isMissing({ module }: ModuleNode, { modules }: Surroundings): boolean {
  return (
    module.onProcessingStringified === '' && modules !== undefined && !modules.has(module.name)
  );
}

function* misfits(graph: Graph): Iterable<GraphProblem> {
  for (const { id, from, to } of graph.wires.values()) {
    const fit = fitOf(graph, from, to);
    if (fit.fits) continue;
    const isInput = graph.nodes.get(to.node)?.kind === 'module';
    const { node, port } = isInput ? to : from;
    yield { ...error('format_mismatch', fit.reason), node, port, wires: [id] };
  }
}

function* moduleProblems(graph: Graph, around: Surroundings): Iterable<GraphProblem> {
  for (const node of graph.nodes.values()) {
    if (node.kind !== 'module') continue;
    const { module, id, ports } = node;
    if (isMissing(node, around)) {
      const message = `The module ${quoted(module.name)} is unknown: neither the session, the library nor a connected node has its code. Import it into the module library, or start a node that has it.`;
      yield { ...error('module_unknown', message), node: id };
      continue;
    }
    const isPlaced = module.nodeId !== '' && module.extension?.replaceable !== true;
    if (isPlaced && around.nodes !== undefined && !around.nodes.has(module.nodeId)) {
      const message = `The node of module ${quoted(module.name)} is not connected. Start this node, or choose another one.`;
      yield { ...warning('node_unavailable', message), node: id };
    }
    for (const { name, direction, isDeclared, id: port } of ports) {
      if (isDeclared) continue;
      const others = ports.filter((one) => one.isDeclared && one.direction === direction);
      const known = others.map((one) => one.name).join(', ') || 'none';
      const message = `The module ${quoted(module.name)} has no ${direction}put ${quoted(name)}. Its ${direction}puts: ${known}.`;
      const code = direction === 'in' ? 'unknown_input' : 'unknown_output';
      yield { ...error(code, message), node: id, port };
    }
  }
}

function* doubleWriters(graph: Graph): Iterable<GraphProblem> {
  for (const node of graph.nodes.values()) {
    if (node.kind !== 'topic') continue;
    const writers = wiresOf(graph, node.id).in;
    if (writers.length < 2) continue;
    const names = writers.map(({ from }) => quoted(nameOf(graph, from.node)));
    const who = names.length === 2 ? `Both ${names.join(' and ')}` : `All of ${names.join(', ')}`;
    yield {
      ...warning('topic_written_twice', `${who} write this topic; the last record wins.`),
      node: node.id,
      wires: writers.map(({ id }) => id),
    };
  }
}

function* cycles(graph: Graph): Iterable<GraphProblem> {
  for (const { nodes, wires } of cyclesIn(graph)) {
    const names = nodes.map((id) => quoted(nameOf(graph, id)));
    const who = plural(
      names.length,
      `The module ${names[0]} is connected to itself`,
      `The modules ${names.join(', ')} are connected in a loop`,
    );
    const message = `${who}. Make sure that the values do not grow without limit.`;
    for (const [index, node] of nodes.entries())
      yield { ...warning('cycle', message), node, wires, isEcho: index > 0 };
  }
}

const error = (code: string, message: string): GraphProblem => ({
  ...PLACE,
  code,
  message,
  isError: true,
});
const warning = (code: string, message: string): GraphProblem => ({
  ...PLACE,
  code,
  message,
  isError: false,
});
const PLACE = { node: undefined, port: undefined, wires: [] } as const;

const quoted = (name: string): string => `"${name || 'no name'}"`;
function nameOf(graph: Graph, id: string): string {
  const node = graph.nodes.get(id);
  if (node?.kind === 'module') return node.module.name;
  return node?.kind === 'demuxer' ? node.demux.name : id;
}
