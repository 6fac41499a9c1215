import type { GraphNode } from '../model/graph.ts';
import { constantText } from './constant-value.ts';
import { shortTopic } from './topic-words.ts';

/** Name of a node in lists and for screen readers. */
export function nodeTitle(node: GraphNode): string {
  switch (node.kind) {
    case 'topic':
      return shortTopic(node.topic);
    case 'module':
      return node.module.name || 'Module without a name';
    case 'muxer':
      return node.mux.name || 'Muxer';
    case 'demuxer':
      return node.demux.name || 'Demuxer';
    case 'constant':
      return node.name || constantText(node.json) || 'Value';
    case 'comment':
      return node.text || 'Note';
    case 'frame':
      return node.title || 'Frame';
  }
}

const KINDS: Readonly<Record<GraphNode['kind'], string>> = {
  topic: 'Topic',
  module: 'Module',
  muxer: 'Muxer',
  demuxer: 'Demuxer',
  constant: 'Value',
  comment: 'Note',
  frame: 'Frame',
};

export const nodeKind = ({ kind }: GraphNode): string => KINDS[kind];

/** Kind and name: `Module Proximity`. */
export function nodeLabel(node: GraphNode): string {
  const title = node.kind === 'topic' ? node.topic : nodeTitle(node);
  return title === nodeKind(node) ? title : `${nodeKind(node)} ${title}`;
}
