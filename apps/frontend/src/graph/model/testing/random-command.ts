import { fromJson } from '@ubii/proto';
import type { CommandKind, CommandOf, GraphCommand } from '../commands/graph-command.ts';
import { topicPart } from '../commands/free-topic.ts';
import type { Graph, GraphNode, PortRef } from '../graph.ts';
import {
  commentNode,
  constantNode,
  frameNode,
  moduleNode,
  muxerNode,
  topicNode,
} from '../make-node.ts';

/** Returns the next number of a sequence, for random choices. */
export type Numbers = () => number;

export function numbersOf(list: readonly number[]): Numbers {
  let index = 0;
  return () => list[index++ % Math.max(1, list.length)] ?? 0;
}

/** Returns a command, mostly about existing elements. Derived from numbers, so that fast-check can shrink failures. */
export function randomCommand(graph: Graph, next: Numbers): GraphCommand {
  const kinds = Object.keys(MAKERS) as CommandKind[];
  const kind = kinds[next() % kinds.length]!;
  return (MAKERS[kind] as (graph: Graph, next: Numbers) => GraphCommand)(graph, next);
}

type Maker<K extends CommandKind> = (graph: Graph, next: Numbers) => CommandOf<K>;

const nodeId = (graph: Graph, next: Numbers): string =>
  [...graph.nodes.keys()][next() % (graph.nodes.size + 1)] ?? 'unknown';
const wire = (graph: Graph, next: Numbers): string =>
  [...graph.wires.keys()][next() % (graph.wires.size + 1)] ?? 'no wire';
const nodeIds = (graph: Graph, next: Numbers): string[] => [
  nodeId(graph, next),
  nodeId(graph, next),
];
const topic = (next: Numbers): string => ['/a', '/b', '/new', '/one', ''][next() % 5]!;
const point = (next: Numbers): { x: number; y: number } => ({ x: next(), y: next() });

function port(graph: Graph, next: Numbers, direction: 'in' | 'out'): PortRef {
  const refs = [...graph.nodes.values()].flatMap(({ id, ports }) =>
    ports.filter((one) => one.direction === direction).map((one) => ({ node: id, port: one.id })),
  );
  return refs[next() % Math.max(1, refs.length)] ?? { node: 'unknown', port: 'x' };
}

function newNode(graph: Graph, next: Numbers): GraphNode {
  const id = String(graph.nodes.size + next());
  const look = { position: point(next) };
  const io = { internalName: 'x', messageFormat: 'double' };
  const makers: (() => GraphNode)[] = [
    () => topicNode(topic(next) || '/t', look),
    () => commentNode(`comment:${id}`, 'note', look),
    () => frameNode(`frame:${id}`, 'Frame', look),
    () => constantNode(`constant:${id}`, '{"double":1}', look),
    () => muxerNode(fromJson('ubii.devices.TopicMux', { id: `mux${id}`, topicGlob: '/*' }), look),
    () =>
      moduleNode(
        fromJson('ubii.processing.ProcessingModule', {
          id: `new${id}`,
          name: topicPart(id),
          inputs: [io],
          outputs: [io],
        }),
        look,
      ),
  ];
  return makers[next() % makers.length]!();
}

const MAKERS: { readonly [K in CommandKind]: Maker<K> } = {
  all: (graph, next) => ({
    kind: 'all',
    label: 'Two things',
    commands: [MAKERS.connect(graph, next), MAKERS.remove(graph, next)],
  }),
  patch: () => ({
    kind: 'patch',
    label: 'Nothing',
    patch: { nodes: new Map(), wires: new Map(), details: undefined },
  }),
  add: (graph, next) => {
    const node = newNode(graph, next);
    return { kind: 'add', nodes: graph.nodes.has(node.id) ? [] : [node] };
  },
  remove: (graph, next) =>
    next() % 3 === 0
      ? { kind: 'remove', nodes: [nodeId(graph, next)] }
      : { kind: 'remove', wires: [wire(graph, next)] },
  move: (graph, next) => ({
    kind: 'move',
    positions: new Map(nodeIds(graph, next).map((id) => [id, point(next)])),
  }),
  resize: (graph, next) => ({
    kind: 'resize',
    node: nodeId(graph, next),
    size: { width: next(), height: next() },
  }),
  collapse: (graph, next) => ({
    kind: 'collapse',
    nodes: nodeIds(graph, next),
    isCollapsed: next() % 2 === 0,
  }),
  connect: (graph, next) => ({
    kind: 'connect',
    from: port(graph, next, 'out'),
    to: port(graph, next, 'in'),
    ...(next() % 4 === 0 && { via: topic(next) || '/t' }),
  }),
  reroute: (graph, next) => ({ kind: 'reroute', wire: wire(graph, next), points: [point(next)] }),
  setModule: (graph, next) => ({
    kind: 'setModule',
    node: nodeId(graph, next),
    changes: { processingMode: { frequency: { hertz: next() } } },
  }),
  setConstant: (graph, next) => ({
    kind: 'setConstant',
    node: nodeId(graph, next),
    input: 'x',
    json: next() % 3 === 0 ? undefined : '{"double":2}',
  }),
  setStanding: (graph, next) => ({
    kind: 'setStanding',
    nodes: nodeIds(graph, next),
    standing: (['active', 'bypassed', 'muted'] as const)[next() % 3]!,
  }),
  setMuxer: (graph, next) => ({
    kind: 'setMuxer',
    node: nodeId(graph, next),
    changes: { topicGlob: `/${next()}/*` },
  }),
  setDemuxer: (graph, next) => ({
    kind: 'setDemuxer',
    node: nodeId(graph, next),
    changes: { name: `d${next()}` },
  }),
  setValue: (graph, next) => ({
    kind: 'setValue',
    node: nodeId(graph, next),
    json: `{"double":${next()}}`,
  }),
  setText: (graph, next) => ({ kind: 'setText', node: nodeId(graph, next), text: `${next()}` }),
  setColor: (graph, next) => ({
    kind: 'setColor',
    frame: nodeId(graph, next),
    color: next() % 2 === 0 ? '' : 'teal',
  }),
  renameTopic: (graph, next) => ({
    kind: 'renameTopic',
    node: nodeId(graph, next),
    topic: topic(next),
  }),
  setVia: (graph, next) => ({ kind: 'setVia', wire: wire(graph, next), topic: topic(next) }),
  ownTopics: (graph, next) => ({
    kind: 'ownTopics',
    topics: [graph.wires.get(wire(graph, next))?.via ?? topic(next)],
  }),
  showTopic: (graph, next) => ({ kind: 'showTopic', wire: wire(graph, next) }),
  hideTopic: (graph, next) => ({ kind: 'hideTopic', node: nodeId(graph, next) }),
  group: (graph, next) => ({
    kind: 'group',
    frame: frameNode(`frame:${graph.nodes.size}`, 'Group', { position: point(next) }),
    nodes: nodeIds(graph, next),
  }),
  ungroup: (graph, next) => ({ kind: 'ungroup', frame: nodeId(graph, next) }),
  setFrame: (graph, next) => ({
    kind: 'setFrame',
    nodes: nodeIds(graph, next),
    frame: next() % 2 === 0 ? undefined : nodeId(graph, next),
  }),
  setDetails: (_graph, next) => ({ kind: 'setDetails', changes: { name: `s${next()}` } }),
};
