import type { DataFormat } from '@ubii/proto';
import { fieldKind, isTypable, partNames } from '../../formats/value-parts.ts';
import type { Graph, GraphNode, ModuleNode, Point, Port, Size } from '../model/graph.ts';
import { portFormat } from '../model/port-format.ts';
import { canCollapse } from './collapse.ts';
import { NODE } from './node-geometry.ts';
import { nodeTitle } from './node-label.ts';

/** Largest width of a node; longer names are shortened. */
const MAX_WIDTH = 272;
/** Average width of a character, with some reserve. */
const CHARACTER = 7.6;
/** Width beside the name of a module, for icon and status. */
const HEAD_MARKS = 96;
/** Width beside the name of a topic, of a muxer or demuxer, and of a value, pixels. */
export const BESIDE = { topic: 48, mux: 72, constant: 46 } as const;
/** Width beside the name of a port, for sockets and a value or field. */
const FIELD_ROW = 108;
/** The same for a value with one field per number: fixed part, and part per field. */
const PARTS_ROW = 52;
const PART = 56;
const VALUE_ROW = 74;
const PICTURE = NODE.pictureHeight + NODE.pictureMargin;
const ROWS_PADDING = 2 * NODE.rowsPadding;
const BORDERS = 2 * NODE.border;
const PATTERN = 28;
/** Most topics that a muxer shows. */
const MATCHES = 3;

/** Height of a node without rows. */
const BARE = BORDERS + NODE.head + ROWS_PADDING;

/** Height of all rows of a module. */
export const rowsHeight = ({ ports }: ModuleNode): number => ROWS_PADDING + NODE.row * ports.length;

function rowWidth({ name, direction, format, isList }: Port): number {
  const text = name.length * CHARACTER;
  if (direction === 'out' || isList || format === undefined || !isTypable(format)) {
    return text + VALUE_ROW;
  }
  const isParts = fieldKind(format) === 'parts';
  return text + (isParts ? PARTS_ROW + PART * partNames(format).length : FIELD_ROW);
}

function moduleWidth({ module: { name }, ports }: ModuleNode): number {
  const longest = Math.max(name.length * CHARACTER + HEAD_MARKS, ...ports.map(rowWidth));
  return Math.min(MAX_WIDTH, Math.max(NODE.width, Math.ceil(longest)));
}

const widthOf = (title: string, beside: number, least: number): number =>
  Math.min(MAX_WIDTH, Math.max(least, Math.ceil(title.length * CHARACTER + beside)));

/** Width of a node for its longest name, within limits, pixels. */
export function nodeWidth(node: GraphNode): number {
  switch (node.kind) {
    case 'module':
      return moduleWidth(node);
    case 'topic':
      return widthOf(nodeTitle(node), BESIDE.topic, NODE.topicWidth);
    case 'muxer':
    case 'demuxer':
      return widthOf(nodeTitle(node), BESIDE.mux, NODE.width);
    case 'constant':
      return widthOf(node.name, BESIDE.constant, NODE.width);
    case 'comment':
      return 220;
    case 'frame':
      return 320;
  }
}

/** Topics that show a picture: their own, or the one that their objects were detected in. */
const isPicture = (format: DataFormat | undefined): boolean =>
  format === 'image2D' || format === 'object2DList';

function drawnHeight(node: GraphNode): number {
  switch (node.kind) {
    case 'topic':
      return NODE.topicHeight + (isPicture(node.format) ? PICTURE : 0);
    case 'module':
      return BARE + NODE.row * node.ports.length + NODE.foot;
    case 'muxer':
      return BARE + PATTERN + NODE.row * (MATCHES + 2);
    case 'demuxer':
      return BARE + PATTERN + NODE.row * (MATCHES + 1);
    case 'constant':
      return BARE + NODE.row;
    case 'comment':
      return 60;
    case 'frame':
      return 200;
  }
}

/** Estimates the size of a node before it is drawn. */
export function drawnSize(node: GraphNode): Size {
  const width = nodeWidth(node);
  if (node.isCollapsed && canCollapse(node)) return { width, height: NODE.head };
  return node.size ?? { width, height: drawnHeight(node) };
}

/** The same for nodes of a graph, in which wires determine the formats of topics. */
export const drawnSizeIn =
  (graph: Graph) =>
  (node: GraphNode): Size => {
    if (node.kind !== 'topic' || node.format !== undefined) return drawnSize(node);
    const at = (port: string): DataFormat | undefined => portFormat(graph, { node: node.id, port });
    return drawnSize({ ...node, format: at('out') ?? at('in') });
  };

/**
 * Estimates the position of a socket relative to the top left of its node.
 * @param size of the node
 */
export function drawnSocket(node: GraphNode, port: string, { width, height }: Size): Point {
  const index = node.ports.findIndex(({ id }) => id === port);
  const x = node.ports[index]?.direction === 'in' ? BORDERS / 2 : width - BORDERS / 2;
  if (node.kind === 'topic') return { x, y: height / 2 };
  if (node.kind !== 'module' || node.isCollapsed) return { x, y: (BORDERS + NODE.head) / 2 };
  return { x, y: BORDERS / 2 + NODE.head + ROWS_PADDING / 2 + NODE.row * (index + 0.5) };
}
