import { fromJson, parseDataFormat, toJson, type JsonObject, type JsonValue } from '@ubii/proto';
import type { GraphNode, ModuleNode, Standing, Wire } from '../graph.ts';
import {
  commentNode,
  constantNode,
  demuxerNode,
  frameNode,
  moduleNode,
  muxerNode,
  topicNode,
} from '../make-node.ts';

export const isObject = (value: unknown): value is Record<string, JsonValue> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

/** A node as text of the clipboard has it. */
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

/**
 * A new node like the one that was copied.
 * @param ids gets the new id by the old one
 * @throws TypeError or DecodeError when it is none
 */
export function nodeFromJson(
  json: unknown,
  uuid: () => string,
  ids: Map<string, string>,
): GraphNode {
  if (!isObject(json)) throw new TypeError('a node is not an object');
  const { x, y, width, height } = json;
  const look = {
    position: typeof x === 'number' && typeof y === 'number' ? { x, y } : undefined,
    size: typeof width === 'number' && typeof height === 'number' ? { width, height } : undefined,
    isCollapsed: json.collapsed === true,
    frame: typeof json.frame === 'string' ? json.frame : undefined,
  };
  const node = newNode(json, uuid, look);
  ids.set(textOf(json, 'id'), node.id);
  return node;
}

function newNode(
  json: Record<string, JsonValue>,
  uuid: () => string,
  look: Parameters<typeof commentNode>[2] & object,
): GraphNode {
  const { kind } = json;
  switch (kind) {
    case 'topic':
      return topicNode(textOf(json, 'topic'), {
        ...look,
        format: parseDataFormat(textOf(json, 'format')),
      });
    case 'module': {
      const module = fromJson('ubii.processing.ProcessingModule', json.module);
      const [mappedInputs, mappedOutputs] = Array.isArray(json.mapped) ? json.mapped : [];
      return moduleNode(
        { ...module, id: uuid(), sessionId: '', status: 0 },
        {
          ...look,
          constants: new Map(pairs(json.constants)),
          standing: STANDINGS.find((one) => one === json.standing) ?? 'active',
          mappedInputs: texts(mappedInputs),
          mappedOutputs: texts(mappedOutputs),
        },
      );
    }
    case 'muxer': {
      const mux = fromJson('ubii.devices.TopicMux', json.message);
      return muxerNode({ ...mux, id: uuid() }, look);
    }
    case 'demuxer': {
      const demux = fromJson('ubii.devices.TopicDemux', json.message);
      return demuxerNode({ ...demux, id: uuid() }, look);
    }
    case 'constant':
      return constantNode(`constant:${uuid()}`, textOf(json, 'json'), {
        ...look,
        name: textOf(json, 'name'),
      });
    case 'comment':
      return commentNode(`comment:${uuid()}`, textOf(json, 'text'), look);
    case 'frame':
      return frameNode(`frame:${uuid()}`, textOf(json, 'title'), {
        ...look,
        color: typeof json.color === 'string' ? json.color : '',
      });
    default:
      throw new TypeError(`the node kind ${JSON.stringify(kind)} is unknown`);
  }
}

const STANDINGS: readonly Standing[] = ['bypassed', 'muted'];

/** Names that only mappings contain, mostly of unknown modules. */
const undeclared = ({ ports }: ModuleNode, direction: 'in' | 'out'): string[] =>
  ports.filter((port) => port.direction === direction && !port.isDeclared).map(({ name }) => name);

const texts = (value: unknown): string[] =>
  Array.isArray(value) ? value.filter((one) => typeof one === 'string') : [];

function textOf(json: Record<string, JsonValue>, name: string): string {
  const value = json[name];
  if (typeof value !== 'string') throw new TypeError(`${name} is not a text`);
  return value;
}

function pairs(value: unknown): (readonly [string, string])[] {
  if (!Array.isArray(value)) return [];
  return value.flatMap((pair: unknown) => {
    const [name, json] = Array.isArray(pair) ? (pair as readonly unknown[]) : [];
    return typeof name === 'string' && typeof json === 'string' ? [[name, json] as const] : [];
  });
}
