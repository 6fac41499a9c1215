import {
  fromJson,
  parseDataFormat,
  ProcessingModuleStatus,
  type ProcessingModule,
} from '@ubii/proto';
import type { GraphNode, Point } from '../model/graph.ts';
import {
  commentNode,
  constantNode,
  demuxerNode,
  frameNode,
  moduleNode,
  muxerNode,
  topicNode,
} from '../model/make-node.ts';

/** What can be put on the canvas. */
export type NewNode =
  | { readonly kind: 'topic'; readonly topic: string; readonly format: string }
  | { readonly kind: 'module'; readonly module: ProcessingModule }
  | { readonly kind: 'muxer' | 'demuxer' | 'constant' | 'comment' | 'frame' };

/** A module of the library as a session has it: under an id of its own, placed by the master. */
export function freshModule(module: ProcessingModule, uuid: () => string): ProcessingModule {
  const { version = '', libraries = [] } = module.extension ?? {};
  return {
    ...module,
    id: uuid(),
    nodeId: '',
    sessionId: '',
    status: ProcessingModuleStatus.INITIALIZED,
    extension: module.extension && { ...module.extension, version, libraries, replaceable: false },
  };
}

/** @param uuid gives a new UUID */
export function newNode(what: NewNode, position: Point, uuid: () => string): GraphNode {
  switch (what.kind) {
    case 'topic':
      return topicNode(what.topic, { position, format: parseDataFormat(what.format) });
    case 'module':
      return moduleNode(freshModule(what.module, uuid), { position });
    case 'muxer':
      return muxerNode(fromJson('ubii.devices.TopicMux', { id: uuid(), name: 'Muxer' }), {
        position,
      });
    case 'demuxer':
      return demuxerNode(fromJson('ubii.devices.TopicDemux', { id: uuid(), name: 'Demuxer' }), {
        position,
      });
    case 'constant':
      return constantNode(`constant:${uuid()}`, '{"double":0}', { position });
    case 'comment':
      return commentNode(`comment:${uuid()}`, 'Note', { position });
    case 'frame':
      return frameNode(`frame:${uuid()}`, 'Frame', { position, size: { width: 320, height: 220 } });
  }
}
