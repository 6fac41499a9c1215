import { nodeName } from '../commands/command-label.ts';
import type { GraphCommand } from '../commands/graph-command.ts';
import { fitEnds } from '../fit/fit-of.ts';
import { endOf, type WireEnd } from '../fit/wire-end.ts';
import {
  wireId,
  type Graph,
  type GraphNode,
  type Point,
  type Port,
  type PortRef,
  type Wire,
} from '../graph.ts';
import { wiresAt, wiresOf } from '../wires-of.ts';
import type { Box } from './arrange.ts';
import { makeRoom } from './make-room.ts';

/** Ports through which a wire passes a node. */
export interface Insertion {
  readonly input: string;
  readonly output: string;
}

/**
 * Returns the ports through which a wire would pass a node that is dropped on it; undefined when it does not fit. Skips
 * inputs that are wired. The node need not be in the graph.
 */
export function insertionOf(graph: Graph, wire: Wire, node: GraphNode): Insertion | undefined {
  if (wire.from.node === node.id || wire.to.node === node.id) return undefined;
  const from = endOf(graph, wire.from);
  const to = endOf(graph, wire.to);
  if (from === undefined || to === undefined) return undefined;
  const end = (port: Port): WireEnd => ({
    ref: { node: node.id, port: port.id },
    node,
    port,
    format: port.format,
  });
  const input = node.ports.find(
    (port) =>
      port.direction === 'in' &&
      wiresAt(graph, { node: node.id, port: port.id }).length === 0 &&
      fitEnds(graph, from, end(port)).fits,
  );
  const output = node.ports.find(
    (port) => port.direction === 'out' && fitEnds(graph, end(port), to).fits,
  );
  return input && output && { input: input.id, output: output.id };
}

/**
 * Inserts a node into a wire, and adds it to the graph if necessary; undefined when it does not fit.
 * @param leg number of bend points of the wire before the node
 * @param boxes of all nodes, with the new one at its position: nodes downstream move aside
 */
export function insertOnWire(
  graph: Graph,
  id: string,
  node: GraphNode,
  leg = 0,
  boxes: readonly Box[] = [],
): GraphCommand | undefined {
  const wire = graph.wires.get(id);
  const insertion = wire && insertionOf(graph, wire, node);
  if (wire === undefined || insertion === undefined) return undefined;
  const at = (port: string): PortRef => ({ node: node.id, port });
  const box = boxes.find((one) => one.id === node.id);
  const room = box && makeRoom(graph, wire, box, boxes);
  const isThere = graph.nodes.has(node.id);
  const position = room?.position ?? node.position;
  const [before, behind] = [wire.points.slice(0, leg), wire.points.slice(leg)];
  const shift = room?.shift ?? 0;
  return {
    kind: 'all',
    label: `Insert ${nodeName(node)} on a wire`,
    commands: [
      { kind: 'add', nodes: isThere ? [] : [{ ...node, position, frame: frameOf(graph, wire) }] },
      ...(isThere && position !== undefined
        ? [{ kind: 'move', positions: new Map([[node.id, position]]) } as const]
        : []),
      ...(room?.commands ?? []),
      { kind: 'remove', wires: [id] },
      connectKeepingTopic(graph, wire, at(insertion.input)),
      { kind: 'connect', from: at(insertion.output), to: wire.to },
      reroute(wire.from, at(insertion.input), before),
      reroute(
        at(insertion.output),
        wire.to,
        behind.map(({ x, y }) => ({ x: x + shift, y })),
      ),
    ],
  };
}

/** The frame that contains both ends of a wire. */
function frameOf({ nodes }: Graph, { from, to }: Wire): string | undefined {
  const frame = nodes.get(from.node)?.frame;
  return frame === nodes.get(to.node)?.frame ? frame : undefined;
}

const reroute = (from: PortRef, to: PortRef, points: readonly Point[]): GraphCommand => ({
  kind: 'reroute',
  wire: wireId(from, to),
  points,
});

/** The wire before the node keeps its topic. */
function connectKeepingTopic(graph: Graph, { from, via }: Wire, to: PortRef): GraphCommand {
  return { kind: 'connect', from, to, ...(via !== undefined && { via }) };
}

/** Returns the wires that a node fits into. */
export function wiresToInsertOn(graph: Graph, node: GraphNode): Wire[] {
  const own = new Set(wiresOf(graph, node.id).out.map(({ id }) => id));
  return [...graph.wires.values()].filter(
    (wire) => !own.has(wire.id) && insertionOf(graph, wire, node) !== undefined,
  );
}
