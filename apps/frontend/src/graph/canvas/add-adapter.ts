import { fromJson } from '@ubii/proto';
import type { GraphCommand } from '../model/commands/graph-command.ts';
import type { Adapter } from '../model/fit/adapter.ts';
import { PICK_PATH } from '../model/fit/offers.ts';
import type { Graph, GraphNode, Point, PortRef } from '../model/graph.ts';
import { demuxerNode, moduleNode, muxerNode } from '../model/make-node.ts';
import { IN, inputPort, OUT, outputPort } from '../model/ports.ts';
import { freshModule } from './new-nodes.ts';

/**
 * Puts what was offered between two ports, as one step; undefined for what takes more than one node.
 * @param at where the new node goes
 */
export function adapterCommand(
  graph: Graph,
  { from, to }: { readonly from: PortRef; readonly to: PortRef },
  adapter: Adapter,
  at: Point,
  uuid: () => string,
): GraphCommand | undefined {
  const label = `Connect by ${adapter.label}`;
  const step = (
    node: GraphNode,
    wires: readonly (readonly [PortRef, PortRef])[],
  ): GraphCommand => ({
    kind: 'all',
    label,
    commands: [
      { kind: 'add', nodes: [node] },
      ...wires.map(([a, b]): GraphCommand => ({ kind: 'connect', from: a, to: b })),
    ],
  });
  switch (adapter.kind) {
    case 'field':
    case 'module': {
      const constants =
        adapter.kind === 'field'
          ? new Map([[PICK_PATH, JSON.stringify({ string: adapter.path })]])
          : undefined;
      const node = moduleNode(freshModule(adapter.module, uuid), {
        position: at,
        ...(constants && { constants }),
      });
      return step(node, [
        [from, { node: node.id, port: inputPort(adapter.input) }],
        [{ node: node.id, port: outputPort(adapter.output) }, to],
      ]);
    }
    case 'muxer': {
      const { topicGlob, dataType } = adapter;
      const mux = fromJson('ubii.devices.TopicMux', {
        id: uuid(),
        name: 'Muxer',
        topicGlob,
        dataType,
      });
      const node = muxerNode(mux, { position: at });
      return step(node, [[{ node: node.id, port: OUT }, to]]);
    }
    case 'demuxer': {
      const { outputTopicFormat, dataType } = adapter;
      const demux = fromJson('ubii.devices.TopicDemux', {
        id: uuid(),
        name: 'Demuxer',
        outputTopicFormat,
        dataType,
      });
      const node = demuxerNode(demux, { position: at });
      return step(node, [[from, { node: node.id, port: IN }]]);
    }
    case 'spread':
      return undefined;
  }
}
