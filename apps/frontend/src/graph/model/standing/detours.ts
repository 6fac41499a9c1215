import type { IOMapping, Session, TopicInputMapping } from '@ubii/proto';
import { writtenTopics } from '../commands/connect.ts';
import { fitOf } from '../fit/fit-of.ts';
import type { Graph, ModuleNode, PortRef } from '../graph.ts';
import { moduleNodeId } from '../make-node.ts';
import { ioName } from '../ports.ts';
import { sourceOf } from '../read-mappings.ts';
import { feeding } from '../selection/reconnect.ts';
import { wiresOf } from '../wires-of.ts';
import type { Aside, Detour, SetAside } from './set-aside.ts';

/**
 * Returns the bypassed and muted modules of a graph, with the detours around them.
 * @param full the session with all modules
 */
export function asideOf(graph: Graph, full: Session): Aside {
  const resting = new Map<string, ModuleNode>();
  for (const node of graph.nodes.values()) {
    // Modules without an id could not be identified later.
    if (node.kind !== 'module' || node.standing === 'active') continue;
    if (node.module.id !== '' && node.id === moduleNodeId(node.module.id)) {
      resting.set(node.id, node);
    }
  }
  const modules = [...resting.values()].map((node) => setAsideOf(node, full));
  return { modules, detours: resting.size === 0 ? [] : detoursOf(graph, full, resting) };
}

function setAsideOf({ module, standing }: ModuleNode, full: Session): SetAside {
  const mappingIndex = full.ioMappings.findIndex(
    ({ processingModuleId }) => processingModuleId === module.id,
  );
  return {
    standing: standing === 'muted' ? 'muted' : 'bypassed',
    module,
    mapping: full.ioMappings[mappingIndex],
    moduleIndex: full.processingModules.findIndex(({ id }) => id === module.id),
    mappingIndex: Math.max(0, mappingIndex),
  };
}

function detoursOf(
  graph: Graph,
  full: Session,
  resting: ReadonlyMap<string, ModuleNode>,
): Detour[] {
  const mappings = new Map(full.ioMappings.map((one) => [one.processingModuleId, one]));
  const detours: Detour[] = [];
  for (const node of graph.nodes.values()) {
    if (node.kind !== 'module' || resting.has(node.id)) continue;
    for (const { from, to } of wiresOf(graph, node.id).in) {
      const source = findSource(graph, resting, from, to, new Set());
      if (source === undefined || source.node === from.node) continue;
      const was = mappingOf(mappings.get(node.module.id), ioName(to.port));
      const now = was && redirected(graph, was, source);
      if (was && now) detours.push({ moduleId: node.module.id, was, now });
    }
  }
  return detours;
}

const mappingOf = (mapping: IOMapping | undefined, input: string): TopicInputMapping | undefined =>
  mapping?.inputMappings.find((one) => one.inputName === input && sourceOf(one) !== undefined);

/** Returns the source of an input with bypassed modules passed through; undefined: none. */
function findSource(
  graph: Graph,
  resting: ReadonlyMap<string, ModuleNode>,
  from: PortRef,
  to: PortRef,
  visited: Set<string>,
): PortRef | undefined {
  if (visited.has(from.node)) return undefined;
  visited.add(from.node);
  const node = graph.nodes.get(from.node);
  const own = resting.get(from.node);
  if (node?.kind === 'topic') {
    const writers = wiresOf(graph, node.id).in.map((wire) => wire.from);
    // A topic with another publisher keeps its values.
    if (writers.length === 0 || writers.some((writer) => !resting.has(writer.node))) return from;
    for (const writer of writers) {
      const source = findSource(graph, resting, writer, to, visited);
      if (source !== undefined) return source;
    }
    return undefined;
  }
  if (own === undefined) return from;
  if (own.standing === 'muted') return undefined;
  for (const wire of feeding(graph, from.node)) {
    const source = findSource(graph, resting, wire.from, to, visited);
    if (source !== undefined && fitOf(graph, source, to).fits) return source;
  }
  return undefined;
}

function redirected(
  graph: Graph,
  was: TopicInputMapping,
  source: PortRef,
): TopicInputMapping | undefined {
  const { topic: _topic, topicMux: _mux, ...rest } = was;
  const node = graph.nodes.get(source.node);
  switch (node?.kind) {
    case 'topic':
      return { ...rest, topic: node.topic };
    case 'muxer':
      return { ...rest, topicMux: node.mux };
    case 'module': {
      const [topic] = writtenTopics(graph, source);
      return topic === undefined ? undefined : { ...rest, topic };
    }
    default:
      return undefined;
  }
}
