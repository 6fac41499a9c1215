import type { DataFormat } from '@ubii/proto';
import { fieldKind, isTypable, partNames } from '../../formats/value-parts.ts';
import type { Graph, GraphNode, ModuleNode, Point, Port, Size } from '../model/graph.ts';
import { portFormat } from '../model/port-format.ts';
import { canCollapse } from './collapse.ts';

/** As graph-node.css draws them, pixels at a zoom of 1. */
export const WIDTH = 184;
/** Names of modules and ports that are longer are cut. */
const MAX_WIDTH = 272;
/** About as wide as a character of a name, with some to spare. */
const CHARACTER = 7.6;
/** What stands beside the name of a module: its icon, its life. */
const HEAD_MARKS = 96;
/** What stands beside the name of a port: sockets, and a value or its field. */
const FIELD_ROW = 108;
/** The same with a field for each number of a value: what is around them, and each. */
const PARTS_ROW = 52;
const PART = 56;
const VALUE_ROW = 74;
const TOPIC: Size = { width: 174, height: 70 };
const PICTURE = 94;
const HEAD = 30;
const ROW = 24;
const ROWS_PADDING = 10;
const BORDERS = 2;
const FOOT = 24;
const PATTERN = 28;
/** Topics that a muxer shows. */
const MATCHES = 3;

/** Without any row. */
const BARE = BORDERS + HEAD + ROWS_PADDING;

/** How high the rows of a module are together. */
export const rowsHeight = ({ ports }: ModuleNode): number => ROWS_PADDING + ROW * ports.length;

function rowWidth({ name, direction, format, isList }: Port): number {
  const text = name.length * CHARACTER;
  if (direction === 'out' || isList || format === undefined || !isTypable(format)) {
    return text + VALUE_ROW;
  }
  const isParts = fieldKind(format) === 'parts';
  return text + (isParts ? PARTS_ROW + PART * partNames(format).length : FIELD_ROW);
}

/** How wide a module is drawn, pixels: as its longest name needs, within limits. */
export function moduleWidth({ module: { name }, ports }: ModuleNode): number {
  const longest = Math.max(name.length * CHARACTER + HEAD_MARKS, ...ports.map(rowWidth));
  return Math.min(MAX_WIDTH, Math.max(WIDTH, Math.ceil(longest)));
}

/** Topics that show a picture: their own, or the one in which their things were found. */
const isPicture = (format: DataFormat | undefined): boolean =>
  format === 'image2D' || format === 'object2DList';

/** About how large a node will be drawn, before it is. */
export function drawnSize(node: GraphNode): Size {
  if (node.isCollapsed && canCollapse(node)) {
    return { width: node.kind === 'module' ? moduleWidth(node) : WIDTH, height: HEAD };
  }
  if (node.size !== undefined) return node.size;
  switch (node.kind) {
    case 'topic':
      return isPicture(node.format) ? { ...TOPIC, height: TOPIC.height + PICTURE } : TOPIC;
    case 'module':
      return { width: moduleWidth(node), height: BARE + ROW * node.ports.length + FOOT };
    case 'muxer':
      return { width: WIDTH, height: BARE + PATTERN + ROW * (MATCHES + 2) };
    case 'demuxer':
      return { width: WIDTH, height: BARE + PATTERN + ROW * (MATCHES + 1) };
    case 'constant':
      return { width: WIDTH, height: BARE + ROW };
    case 'comment':
      return { width: 220, height: 60 };
    case 'frame':
      return { width: 320, height: 200 };
  }
}

/** The same for nodes of a graph, in which wires tell the formats of topics. */
export const drawnSizeIn =
  (graph: Graph) =>
  (node: GraphNode): Size => {
    if (node.kind !== 'topic' || node.format !== undefined) return drawnSize(node);
    const at = (port: string): DataFormat | undefined => portFormat(graph, { node: node.id, port });
    return drawnSize({ ...node, format: at('out') ?? at('in') });
  };

/**
 * About where a socket will be drawn, seen from the top left of its node.
 * @param size of the node
 */
export function drawnSocket(node: GraphNode, port: string, { width, height }: Size): Point {
  const index = node.ports.findIndex(({ id }) => id === port);
  const x = node.ports[index]?.direction === 'in' ? BORDERS / 2 : width - BORDERS / 2;
  if (node.kind === 'topic') return { x, y: height / 2 };
  if (node.kind !== 'module' || node.isCollapsed) return { x, y: (BORDERS + HEAD) / 2 };
  return { x, y: BORDERS / 2 + HEAD + ROWS_PADDING / 2 + ROW * (index + 0.5) };
}
