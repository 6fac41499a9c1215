import { DATA_FORMATS, fromJson, type DataFormat, type ProcessingModule } from '@ubii/proto';
import {
  constantNode,
  demuxerNode,
  moduleNode,
  muxerNode,
  type ModuleNodeParts,
  type NodeLook,
} from './make-node.ts';
import type { ConstantNode, DemuxerNode, ModuleNode, MuxerNode } from './graph.ts';

/** Creates a module node from a module of the library. */
export function newModuleNode(
  module: ProcessingModule,
  uuid: string,
  parts: Omit<ModuleNodeParts, 'id'> = {},
): ModuleNode {
  return moduleNode({ ...module, id: uuid, nodeId: '', sessionId: '', status: 0 }, parts);
}

/** Initial properties of a muxer or demuxer. */
interface SpreaderInit {
  readonly name?: string;
  readonly dataType?: string;
}

export function newMuxerNode(
  uuid: string,
  init: SpreaderInit & { readonly topicGlob?: string } = {},
  look: NodeLook = {},
): MuxerNode {
  return muxerNode(fromJson('ubii.devices.TopicMux', { ...init, id: uuid }), look);
}

export function newDemuxerNode(
  uuid: string,
  init: SpreaderInit & { readonly outputTopicFormat?: string } = {},
  look: NodeLook = {},
): DemuxerNode {
  return demuxerNode(fromJson('ubii.devices.TopicDemux', { ...init, id: uuid }), look);
}

/** Creates a constant with the neutral value of a format. */
export function newConstantNode(
  uuid: string,
  format: DataFormat,
  look: NodeLook & { readonly name?: string } = {},
): ConstantNode {
  return constantNode(`constant:${uuid}`, neutralConstant(format), look);
}

/** JSON text of the neutral value of a format, such as `{"vector2":{"x":0,"y":0}}`. [PM-34] */
export function neutralConstant(format: DataFormat): string {
  return JSON.stringify({ [format]: DATA_FORMATS[format].createDefault() });
}
