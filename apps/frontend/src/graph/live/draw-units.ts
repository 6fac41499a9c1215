import type { Graph, GraphNode } from '../model/graph.ts';
import { topicOfWire } from './topics-in-graph.ts';

/** What is drawn together: a node, and the topics that it shows or feeds. */
export interface DrawUnit {
  readonly node: string;
  readonly topics: readonly string[];
  /** Nodes that show something of it: itself, those its topics flow to, and who writes a topic. */
  readonly shownAt: readonly string[];
  /** Id of the module it is. */
  readonly module: string | undefined;
}

/** Nodes in a band as high as this are drawn from left to right, units of the canvas. */
const BAND = 320;

/**
 * The nodes of a graph with what flows from them, each topic once, in the order in which they lie:
 * browsers paint in tiles, and what is drawn in one frame should be in few of them.
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
