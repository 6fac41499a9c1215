import type { GraphNode, Size } from '../model/graph.ts';
import { canCollapse } from './collapse.ts';

/** As graph-node.css draws them, pixels at a zoom of 1. */
const WIDTH = 184;
const TOPIC: Size = { width: 174, height: 76 };
const PICTURE = 94;
const HEAD = 30;
/** Rows are higher for fingers. */
const ROW = globalThis.matchMedia?.('(pointer: coarse)').matches === true ? 32 : 24;
const ROWS_PADDING = 12;
const FOOT = 24;
const PATTERN = 28;
/** Topics that a muxer shows. */
const MATCHES = 3;

/** About how large a node will be drawn, before it is. */
export function drawnSize(node: GraphNode): Size {
  if (node.isCollapsed && canCollapse(node)) return { width: WIDTH, height: HEAD };
  if (node.size !== undefined) return node.size;
  switch (node.kind) {
    case 'topic':
      return node.format === 'image2D' ? { ...TOPIC, height: TOPIC.height + PICTURE } : TOPIC;
    case 'module':
      return { width: WIDTH, height: HEAD + ROWS_PADDING + ROW * node.ports.length + FOOT };
    case 'muxer':
      return { width: WIDTH, height: HEAD + ROWS_PADDING + PATTERN + ROW * (MATCHES + 2) };
    case 'demuxer':
      return { width: WIDTH, height: HEAD + ROWS_PADDING + PATTERN + ROW * (MATCHES + 1) };
    case 'constant':
      return { width: WIDTH, height: HEAD + ROWS_PADDING + ROW };
    case 'comment':
      return { width: 220, height: 60 };
    case 'frame':
      return { width: 320, height: 200 };
  }
}
