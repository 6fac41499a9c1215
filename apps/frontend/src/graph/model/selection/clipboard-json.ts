import { parseDataFormat, toJson, type JsonObject } from '@ubii/proto';
import * as v from 'valibot';
import { finite, flag, maybe, message, textOrNone, validElements } from '../../../json/schemas.ts';
import type { GraphNode, ModuleNode, Wire } from '../graph.ts';
import {
  commentNode,
  constantNode,
  demuxerNode,
  frameNode,
  moduleNode,
  muxerNode,
  topicNode,
} from '../make-node.ts';

/** Converts a node to the JSON of the clipboard. */
export function nodeToJson(node: GraphNode): JsonObject {
  const { id, kind, position, size, isCollapsed, frame } = node;
  const look: JsonObject = {
    id,
    kind,
    ...position,
    ...size,
    ...(isCollapsed && { collapsed: true }),
    ...(frame !== undefined && { frame }),
  };
  switch (node.kind) {
    case 'topic':
      return { ...look, topic: node.topic, format: node.format ?? '' };
    case 'module':
      return {
        ...look,
        module: toJson('ubii.processing.ProcessingModule', node.module),
        constants: [...node.constants].map((pair) => [...pair]),
        standing: node.standing,
        mapped: [undeclared(node, 'in'), undeclared(node, 'out')],
      };
    case 'muxer':
      return { ...look, message: toJson('ubii.devices.TopicMux', node.mux) };
    case 'demuxer':
      return { ...look, message: toJson('ubii.devices.TopicDemux', node.demux) };
    case 'constant':
      return { ...look, name: node.name, json: node.json };
    case 'comment':
      return { ...look, text: node.text };
    case 'frame':
      return { ...look, title: node.title, color: node.color };
  }
}

export const wireToJson = ({ from, to, via, points }: Wire): JsonObject => ({
  from: [from.node, from.port],
  to: [to.node, to.port],
  ...(via !== undefined && { via }),
  points: points.map(({ x, y }) => [x, y]),
});

/** Members that cannot be read, such as those of another version, get the defaults of new nodes. */
const LOOK = {
  id: v.string(),
  x: maybe(finite),
  y: maybe(finite),
  width: maybe(finite),
  height: maybe(finite),
  collapsed: flag,
  frame: maybe(v.string()),
};
const texts = v.fallback(validElements(v.string()), []);

const NODE = v.variant('kind', [
  v.object({ ...LOOK, kind: v.literal('topic'), topic: v.string(), format: v.string() }),
  v.object({
    ...LOOK,
    kind: v.literal('module'),
    module: message('ubii.processing.ProcessingModule'),
    constants: v.fallback(validElements(v.tuple([v.string(), v.string()])), []),
    standing: v.fallback(v.picklist(['active', 'bypassed', 'muted']), 'active'),
    mapped: v.fallback(v.tuple([texts, texts]), [[], []]),
  }),
  v.object({ ...LOOK, kind: v.literal('muxer'), message: message('ubii.devices.TopicMux') }),
  v.object({ ...LOOK, kind: v.literal('demuxer'), message: message('ubii.devices.TopicDemux') }),
  v.object({ ...LOOK, kind: v.literal('constant'), name: v.string(), json: v.string() }),
  v.object({ ...LOOK, kind: v.literal('comment'), text: v.string() }),
  v.object({ ...LOOK, kind: v.literal('frame'), title: v.string(), color: textOrNone }),
]);
type NodeJson = v.InferOutput<typeof NODE>;

const END = v.tuple([v.string(), v.string()]);

/** Schema of the clipboard: nodes and wires; wires that cannot be read are omitted. */
export const CLIPBOARD = v.object({
  nodes: v.array(NODE),
  wires: validElements(v.object({ from: END, to: END, via: maybe(v.string()) })),
});

/**
 * Creates a node from a copied one.
 * @param ids receives the new id, by the old one
 */
export function nodeFromJson(
  json: NodeJson,
  uuid: () => string,
  ids: Map<string, string>,
): GraphNode {
  const { x, y, width, height, collapsed, frame } = json;
  const node = newNode(json, uuid, {
    position: x !== undefined && y !== undefined ? { x, y } : undefined,
    size: width !== undefined && height !== undefined ? { width, height } : undefined,
    isCollapsed: collapsed,
    frame,
  });
  ids.set(json.id, node.id);
  return node;
}

function newNode(
  json: NodeJson,
  uuid: () => string,
  look: Parameters<typeof commentNode>[2] & object,
): GraphNode {
  switch (json.kind) {
    case 'topic':
      return topicNode(json.topic, { ...look, format: parseDataFormat(json.format) });
    case 'module': {
      const [mappedInputs, mappedOutputs] = json.mapped;
      return moduleNode(
        { ...json.module, id: uuid(), sessionId: '', status: 0 },
        {
          ...look,
          constants: new Map(json.constants),
          standing: json.standing,
          mappedInputs,
          mappedOutputs,
        },
      );
    }
    case 'muxer':
      return muxerNode({ ...json.message, id: uuid() }, look);
    case 'demuxer':
      return demuxerNode({ ...json.message, id: uuid() }, look);
    case 'constant':
      return constantNode(`constant:${uuid()}`, json.json, { ...look, name: json.name });
    case 'comment':
      return commentNode(`comment:${uuid()}`, json.text, look);
    case 'frame':
      return frameNode(`frame:${uuid()}`, json.title, { ...look, color: json.color });
  }
}

/** Names that occur only in mappings, mostly of unknown modules. */
const undeclared = ({ ports }: ModuleNode, direction: 'in' | 'out'): string[] =>
  ports.filter((port) => port.direction === direction && !port.isDeclared).map(({ name }) => name);
