import { toJson, type JsonObject, type JsonValue } from '@ubii/proto';
import { EDITOR_FORMAT, EDITOR_VERSION } from '../../sessions/text/editor-format.ts';
import type { Graph, GraphNode } from './graph.ts';
import { ioName } from './ports.ts';
import { asideJson, NOTHING_ASIDE, type Aside } from './standing/set-aside.ts';
import { wiresOf } from './wires-of.ts';

/** Serialises the editor data of a graph to JSON; equal graphs give equal text. */
export function editorDataText(graph: Graph, aside: Aside = NOTHING_ASIDE): string {
  const nodes = new Map<string, JsonObject>();
  for (const node of graph.nodes.values()) nodes.set(node.id, nodeJson(graph, node));
  const wires = new Map<string, JsonValue>();
  for (const { id, points } of graph.wires.values()) {
    if (points.length > 0)
      wires.set(
        id,
        points.map(({ x, y }) => [x, y]),
      );
  }
  const { nodes: otherNodes, wires: otherWires, ...foreign } = graph.foreign;
  return JSON.stringify({
    format: EDITOR_FORMAT,
    version: EDITOR_VERSION,
    ...foreign,
    nodes: section(nodes, otherNodes),
    wires: section(wires, otherWires),
    aside: asideJson(aside),
  });
}

/** Own entries of a section, together with those of other programs, by key. */
function section(ours: ReadonlyMap<string, JsonValue>, others: JsonValue | undefined): JsonValue {
  const left = isObject(others) ? others : {};
  const keys = [...new Set([...ours.keys(), ...Object.keys(left)])].sort();
  return Object.fromEntries(
    keys.map((key) => {
      const own = ours.get(key);
      const other = left[key];
      const both = isObject(own) && isObject(other) ? { ...other, ...own } : (own ?? other ?? null);
      return [key, both];
    }),
  );
}

const isObject = (value: JsonValue | undefined): value is JsonObject =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

function nodeJson(graph: Graph, node: GraphNode): JsonObject {
  const { kind, position, size, isCollapsed, frame } = node;
  return {
    kind,
    ...position,
    ...size,
    ...(isCollapsed && { collapsed: true }),
    ...(frame !== undefined && { frame }),
    ...ownJson(graph, node),
  };
}

/** Properties of a node that the session cannot represent. */
function ownJson(graph: Graph, node: GraphNode): JsonObject {
  switch (node.kind) {
    case 'module':
      return {};
    case 'topic': {
      const { topic, format } = node;
      const known: JsonObject = format === undefined ? {} : { format };
      return isLoose(graph, node) ? { loose: true, topic, ...known } : known;
    }
    case 'muxer':
      return isLoose(graph, node)
        ? { loose: true, message: toJson('ubii.devices.TopicMux', node.mux) }
        : {};
    case 'demuxer':
      return isLoose(graph, node)
        ? { loose: true, message: toJson('ubii.devices.TopicDemux', node.demux) }
        : {};
    case 'constant': {
      const targets = wiresOf(graph, node.id).out.map(({ to }) => [to.node, ioName(to.port)]);
      return { name: node.name, json: node.json, targets: targets.sort() };
    }
    case 'comment':
      return { text: node.text };
    case 'frame':
      return { title: node.title, ...(node.color !== '' && { color: node.color }) };
  }
}

function isLoose(graph: Graph, node: GraphNode): boolean {
  const { in: incoming, out } = wiresOf(graph, node.id);
  return incoming.length === 0 && out.length === 0;
}
