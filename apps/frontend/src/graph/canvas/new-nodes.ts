import { parseDataFormat, type ProcessingModule } from '@ubii/proto';
import type { GraphNode, Point } from '../model/graph.ts';
import { commentNode, frameNode, topicNode } from '../model/make-node.ts';
import { newConstantNode, newDemuxerNode, newModuleNode, newMuxerNode } from '../model/new-node.ts';

/** Description of a node to add to the canvas. */
export type NewNode =
  | { readonly kind: 'topic'; readonly topic: string; readonly format: string }
  | { readonly kind: 'module'; readonly module: ProcessingModule }
  | { readonly kind: 'muxer'; readonly name?: string; readonly topicGlob?: string }
  | { readonly kind: 'demuxer' | 'constant' | 'comment' | 'frame' };

const FRAME_SIZE = { width: 320, height: 220 };

/** @param uuid returns a new UUID */
export function newNode(what: NewNode, position: Point, uuid: () => string): GraphNode {
  switch (what.kind) {
    case 'topic':
      return topicNode(what.topic, { position, format: parseDataFormat(what.format) });
    case 'module':
      return newModuleNode(what.module, uuid(), { position });
    case 'muxer':
      return newMuxerNode(
        uuid(),
        { name: what.name ?? 'Muxer', topicGlob: what.topicGlob ?? '' },
        { position },
      );
    case 'demuxer':
      return newDemuxerNode(uuid(), { name: 'Demuxer' }, { position });
    case 'constant':
      return newConstantNode(uuid(), 'double', { position });
    case 'comment':
      return commentNode(`comment:${uuid()}`, '', { position });
    case 'frame':
      return frameNode(`frame:${uuid()}`, '', { position, size: FRAME_SIZE });
  }
}
