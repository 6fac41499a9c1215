import { wireId, type Graph, type Point, type PortRef, type Wire } from '../graph.ts';
import { topicNode, topicNodeId } from '../make-node.ts';
import { IN, OUT } from '../ports.ts';
import type { GraphEdit } from './graph-edit.ts';

/** Returns the wires between modules that use a topic. */
export function viaWires(graph: Graph, topic: string): Wire[] {
  return [...graph.wires.values()].filter(({ via }) => via === topic);
}

/** Adds a node for a topic, and reroutes the wires between modules through it. */
export function revealTopic(edit: GraphEdit, topic: string, position?: Point): void {
  const node = topicNodeId(topic);
  const wires = viaWires(edit.graph, topic);
  if (!edit.graph.nodes.has(node)) {
    const place = position ?? between(edit.graph, wires[0]);
    edit.putNodes([topicNode(topic, { position: place })]);
  }
  edit.removeWires(wires.map(({ id }) => id));
  edit.putWires(
    wires.flatMap(({ from, to }) => [
      plainWire(from, { node, port: IN }),
      plainWire({ node, port: OUT }, to),
    ]),
  );
}

export function plainWire(from: PortRef, to: PortRef, via?: string): Wire {
  return { id: wireId(from, to), from, to, via, points: [] };
}

function between(graph: Graph, wire: Wire | undefined): Point | undefined {
  const a = graph.nodes.get(wire?.from.node ?? '')?.position;
  const b = graph.nodes.get(wire?.to.node ?? '')?.position;
  return a && b && { x: Math.round((a.x + b.x) / 2), y: Math.round((a.y + b.y) / 2) };
}
