import { applyCommand } from '../model/commands/apply-command.ts';
import { nodeName, portName } from '../model/commands/command-label.ts';
import { fitOf } from '../model/fit/fit-of.ts';
import type { Graph, GraphNode, PortRef, Wire } from '../model/graph.ts';

/** Returns why a node does not fit into a wire, one sentence. The node need not be in the graph. */
export function misfitOnWire(graph: Graph, wire: Wire, node: GraphNode): string {
  const whole = applyCommand(graph, { kind: 'add', nodes: [node] }).graph;
  const reasons = (direction: 'in' | 'out'): string[] =>
    node.ports
      .filter((port) => port.direction === direction)
      .map(({ id }): PortRef => ({ node: node.id, port: id }))
      .map((ref) =>
        direction === 'in' ? fitOf(whole, wire.from, ref) : fitOf(whole, ref, wire.to),
      )
      .map((fit) => (fit.fits ? '' : fit.reason));
  const name = nodeName(node);
  for (const [direction, side] of [
    ['in', 'input'],
    ['out', 'output'],
  ] as const) {
    const found = reasons(direction);
    if (found.length === 0) return `${name} has no ${side} for this wire.`;
    if (!found.includes('')) return `${name} is not compatible with this wire: ${found[0]}`;
  }
  return `All compatible inputs of ${name} are already connected.`;
}

/** Returns the result of an insertion, and what the node still needs to run. */
export function insertedText(
  graph: Graph,
  { from, to }: Wire,
  node: GraphNode,
  isRunning: boolean,
): string {
  const place = `between ${portName(graph, from)} and ${portName(graph, to)}`;
  const next = isRunning ? '' : ' Start the session to run it.';
  return `Inserted ${nodeName(node)} ${place}.${next}`;
}
