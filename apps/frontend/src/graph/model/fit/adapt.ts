import { DATA_FORMATS } from '@ubii/proto';
import { portName } from '../commands/command-label.ts';
import type { GraphCommand } from '../commands/graph-command.ts';
import type { Graph, GraphNode, Point, PortRef } from '../graph.ts';
import { topicNode } from '../make-node.ts';
import { newDemuxerNode, newModuleNode, newMuxerNode } from '../new-node.ts';
import { IN, inputPort, OUT, outputPort } from '../ports.ts';
import { portFormat } from '../port-format.ts';
import type { Adapter } from './adapter.ts';
import { PICK_PATH } from './offers.ts';

/** Options for new nodes. */
export interface NewNodes {
  /** Returns a new UUID. */
  uuid(): string;
  /** Default: half way between the ends. */
  readonly position?: Point;
}

/** Inserts an adapter between two ports, wired to both, as one step. */
export function adaptCommand(
  graph: Graph,
  from: PortRef,
  to: PortRef,
  adapter: Adapter,
  { uuid, position = middle(graph, from, to) }: NewNodes,
): GraphCommand {
  const look = { position };
  const label = `Connect ${portName(graph, from)} to ${portName(graph, to)} with ${adapterName(adapter)}`;
  const { dataType } = { dataType: '', ...adapter };
  const all = (nodes: GraphNode[], wires: [PortRef, PortRef][]): GraphCommand => ({
    kind: 'all',
    label,
    commands: [
      { kind: 'add', nodes },
      ...wires.map(([from, to]) => ({ kind: 'connect', from, to }) as const),
    ],
  });
  switch (adapter.kind) {
    case 'field':
    case 'module': {
      const node = adapterModule(graph, from, adapter, uuid(), look);
      return all(
        [node],
        [
          [from, { node: node.id, port: inputPort(adapter.input) }],
          [{ node: node.id, port: outputPort(adapter.output) }, to],
        ],
      );
    }
    case 'muxer': {
      const { topicGlob } = adapter;
      const mux = newMuxerNode(uuid(), { topicGlob, dataType }, look);
      const wires: [PortRef, PortRef][] = [[{ node: mux.id, port: OUT }, to]];
      if (graph.nodes.get(from.node)?.kind !== 'module') return all([mux], wires);
      // A muxer reads topics, so the output needs one.
      const topic = topicNode(topicGlob, { position: shifted(position, -200) });
      return all([topic, mux], [[from, { node: topic.id, port: IN }], ...wires]);
    }
    case 'demuxer': {
      const { outputTopicFormat } = adapter;
      const demux = newDemuxerNode(uuid(), { outputTopicFormat, dataType }, look);
      return all([demux], [[from, { node: demux.id, port: IN }]]);
    }
    case 'spread': {
      const { outputTopicFormat, topicGlob } = adapter;
      const demux = newDemuxerNode(uuid(), { outputTopicFormat, dataType }, look);
      const place = { position: shifted(position, 200) };
      const mux = newMuxerNode(uuid(), { topicGlob, dataType }, place);
      return all(
        [demux, mux],
        [
          [from, { node: demux.id, port: IN }],
          [{ node: mux.id, port: OUT }, to],
        ],
      );
    }
  }
}

function adapterModule(
  graph: Graph,
  from: PortRef,
  adapter: Extract<Adapter, { kind: 'field' | 'module' }>,
  uuid: string,
  look: { readonly position: Point | undefined },
): GraphNode {
  if (adapter.kind === 'module') return newModuleNode(adapter.module, uuid, look);
  // The demuxer accepts any format; use that of the output.
  const format = portFormat(graph, from);
  const inputs = adapter.module.inputs.map((io) =>
    io.internalName === adapter.input && format !== undefined
      ? { ...io, messageFormat: DATA_FORMATS[format].messageType }
      : io,
  );
  const constants = new Map([[PICK_PATH, JSON.stringify({ string: adapter.path })]]);
  return newModuleNode({ ...adapter.module, inputs }, uuid, { ...look, constants });
}

function adapterName(adapter: Adapter): string {
  switch (adapter.kind) {
    case 'field':
      return `its ${adapter.path}`;
    case 'module':
      return adapter.module.name;
    case 'muxer':
      return 'a muxer';
    case 'demuxer':
      return 'a demuxer';
    case 'spread':
      return 'a topic for each element';
  }
}

function middle(graph: Graph, from: PortRef, to: PortRef): Point | undefined {
  const a = graph.nodes.get(from.node)?.position;
  const b = graph.nodes.get(to.node)?.position;
  return a && b && { x: Math.round((a.x + b.x) / 2), y: Math.round((a.y + b.y) / 2) };
}

const shifted = (point: Point | undefined, x: number): Point | undefined =>
  point && { ...point, x: point.x + x };
