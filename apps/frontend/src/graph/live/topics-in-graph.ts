import type { Graph, PortRef, Wire } from '../model/graph.ts';
import { wiresAt } from '../model/wires-of.ts';

/** Returns the topic whose values flow through a wire; undefined for constants and for several topics. */
export function topicOfWire({ nodes }: Graph, { from, to, via }: Wire): string | undefined {
  if (via !== undefined) return via;
  const source = nodes.get(from.node);
  if (source?.kind === 'topic') return source.topic;
  const target = nodes.get(to.node);
  return target?.kind === 'topic' ? target.topic : undefined;
}

/** Returns all topics that are shown on the canvas. */
export function topicsOf(graph: Graph): ReadonlySet<string> {
  const names = new Set<string>();
  for (const node of graph.nodes.values()) if (node.kind === 'topic') names.add(node.topic);
  for (const { via } of graph.wires.values()) if (via !== undefined) names.add(via);
  return names;
}

/** Returns the topic whose values are at a port; undefined without one, and for several topics. */
export function topicAt(graph: Graph, ref: PortRef): string | undefined {
  const node = graph.nodes.get(ref.node);
  if (node?.kind === 'topic') return node.topic;
  const [wire] = wiresAt(graph, ref);
  return wire && topicOfWire(graph, wire);
}
