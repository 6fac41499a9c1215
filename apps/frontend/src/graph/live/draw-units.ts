import type { Graph, GraphNode } from '../model/graph.ts';
import { topicOfWire } from './topics-in-graph.ts';

/** Unit of drawing: a node, and the topics that it shows or writes. */
export interface DrawUnit {
  readonly node: string;
  readonly topics: readonly string[];
  /** Nodes that show its values: itself, the targets of its topics, and the writers of a topic. */
  readonly shownAt: readonly string[];
  /** Module id of a module node. */
  readonly module: string | undefined;
}

/** Height of the bands in which nodes are drawn from left to right, canvas units. */
const BAND = 320;

/**
 * Nodes of a graph with their topics, each topic once, in spatial order: browsers paint in tiles, and the values of one
 * frame should lie in few of them.
 */
export function drawUnits(graph: Graph): readonly DrawUnit[] {
  const { nodes, wires } = graph;
  const taken = new Set<string>();
  const topicsOf = new Map<string, string[]>();
  const besides = new Map<string, Set<string>>();
  const take = (node: string, topic: string | undefined): void => {
    if (topic === undefined || taken.has(topic)) return;
    taken.add(topic);
    topicsOf.set(node, [...(topicsOf.get(node) ?? []), topic]);
  };
  for (const node of nodes.values()) if (node.kind === 'topic') take(node.id, node.topic);
  for (const wire of wires.values()) {
    const { from, to } = wire;
    take(from.node, topicOfWire(graph, wire));
    besides.set(from.node, (besides.get(from.node) ?? new Set()).add(to.node));
    if (nodes.get(to.node)?.kind === 'topic')
      besides.set(to.node, (besides.get(to.node) ?? new Set()).add(from.node));
  }
  return [...nodes.values()].sort(byPlace).map((node) => ({
    node: node.id,
    topics: topicsOf.get(node.id) ?? [],
    shownAt: [node.id, ...(besides.get(node.id) ?? [])],
    module: node.kind === 'module' ? node.module.id : undefined,
  }));
}

function byPlace({ position: a }: GraphNode, { position: b }: GraphNode): number {
  if (a === undefined || b === undefined) return 0;
  return Math.floor(a.y / BAND) - Math.floor(b.y / BAND) || a.x - b.x;
}
