import type { DataFormat, ProcessingModule, TopicDemux, TopicMux } from '@ubii/proto';
import type {
  CommentNode,
  ConstantNode,
  DemuxerNode,
  FrameNode,
  ModuleNode,
  MuxerNode,
  Point,
  Size,
  Standing,
  TopicNode,
} from './graph.ts';
import { constantPorts, demuxerPorts, modulePorts, muxerPorts, topicPorts } from './ports.ts';

/** Appearance of a node on the canvas. */
export interface NodeLook {
  readonly position?: Point | undefined;
  readonly size?: Size | undefined;
  readonly isCollapsed?: boolean;
  readonly frame?: string | undefined;
}

const base = <K extends string>(
  kind: K,
  id: string,
  { position, size, isCollapsed = false, frame }: NodeLook,
): {
  id: string;
  kind: K;
  position: Point | undefined;
  size: Size | undefined;
  isCollapsed: boolean;
  frame: string | undefined;
} => ({ id, kind, position, size, isCollapsed, frame });

/** Ids of nodes are derived from their content, so that equal sessions give equal graphs. */
export const topicNodeId = (topic: string): string => `topic:${topic}`;
export const moduleNodeId = (moduleId: string): string => `module:${moduleId}`;
export const muxerNodeId = (muxId: string): string => `muxer:${muxId}`;
export const demuxerNodeId = (demuxId: string): string => `demuxer:${demuxId}`;

export function topicNode(
  topic: string,
  look: NodeLook & { readonly format?: DataFormat | undefined } = {},
): TopicNode {
  const { format } = look;
  return { ...base('topic', topicNodeId(topic), look), topic, format, ports: topicPorts(format) };
}

/** Parts of a module node besides its module. */
export interface ModuleNodeParts extends NodeLook {
  /** Default: derived from the id of the module. */
  readonly id?: string;
  readonly constants?: ReadonlyMap<string, string>;
  readonly standing?: Standing;
  /** Names in mappings; undeclared ones get ports, too. */
  readonly mappedInputs?: Iterable<string>;
  readonly mappedOutputs?: Iterable<string>;
}

const NO_CONSTANTS: ReadonlyMap<string, string> = new Map();

export function moduleNode(module: ProcessingModule, parts: ModuleNodeParts = {}): ModuleNode {
  const { id = moduleNodeId(module.id), constants = NO_CONSTANTS, standing = 'active' } = parts;
  const inputs = [...(parts.mappedInputs ?? []), ...constants.keys()];
  const ports = modulePorts(module, { inputs, outputs: parts.mappedOutputs ?? [] });
  return { ...base('module', id, parts), module, constants, standing, ports };
}

export function muxerNode(
  mux: TopicMux,
  look: NodeLook & { readonly id?: string | undefined } = {},
): MuxerNode {
  const { id = muxerNodeId(mux.id) } = look;
  return { ...base('muxer', id, look), mux, ports: muxerPorts(mux) };
}

export function demuxerNode(
  demux: TopicDemux,
  look: NodeLook & { readonly id?: string | undefined } = {},
): DemuxerNode {
  const { id = demuxerNodeId(demux.id) } = look;
  return { ...base('demuxer', id, look), demux, ports: demuxerPorts(demux) };
}

/** @param id new id, such as `constant:` and a UUID */
export function constantNode(
  id: string,
  json: string,
  look: NodeLook & { readonly name?: string } = {},
): ConstantNode {
  const { name = '' } = look;
  return { ...base('constant', id, look), name, json, ports: constantPorts(json) };
}

export function commentNode(id: string, text: string, look: NodeLook = {}): CommentNode {
  return { ...base('comment', id, look), text, ports: [] };
}

export function frameNode(
  id: string,
  title: string,
  look: NodeLook & { readonly color?: string } = {},
): FrameNode {
  const { color = '' } = look;
  return { ...base('frame', id, look), title, color, ports: [] };
}
