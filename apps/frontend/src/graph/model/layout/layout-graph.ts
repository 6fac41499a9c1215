import type { Graph, GraphNode, Point, Size } from '../graph.ts';

/** Node as input of a layout. */
export interface LayoutNode extends Size {
  readonly id: string;
}

/** Graph as input of a layout; a plain object, so that it can be sent to a worker. */
export interface LayoutGraph {
  readonly nodes: readonly LayoutNode[];
  readonly wires: readonly { readonly from: string; readonly to: string }[];
}

/** Returns the nodes and wires to lay out: all that take part in the data flow. */
export function layoutGraphOf(
  graph: Graph,
  sizeOf: (node: GraphNode) => Size,
  wanted: (node: GraphNode) => boolean = () => true,
): LayoutGraph {
  const nodes = [...graph.nodes.values()].filter((node) => isFlow(node) && wanted(node));
  const ids = new Set(nodes.map(({ id }) => id));
  const wires = [...graph.wires.values()].filter(
    ({ from, to }) => ids.has(from.node) && ids.has(to.node) && from.node !== to.node,
  );
  return {
    nodes: nodes.map((node) => ({ id: node.id, ...sizeOf(node) })),
    wires: wires.map(({ from, to }) => ({ from: from.node, to: to.node })),
  };
}

/** Comments and frames stay where the user put them. */
const isFlow = ({ kind }: GraphNode): boolean => kind !== 'comment' && kind !== 'frame';

const WIDTH = 224;
const HEAD = 44;
const ROW = 28;

/** Estimated size of a node that was not measured. */
export function usualSize(node: GraphNode): Size {
  if (node.size !== undefined) return node.size;
  if (node.isCollapsed) return { width: WIDTH, height: HEAD };
  const rows = node.kind === 'module' ? node.ports.length : 1;
  return { width: WIDTH, height: HEAD + ROW * rows };
}

/** Rounds positions to a grid. */
export function onGrid(places: ReadonlyMap<string, Point>, grid: number): Map<string, Point> {
  const to = (value: number): number => Math.round(value / grid) * grid + 0;
  return new Map([...places].map(([id, { x, y }]) => [id, { x: to(x), y: to(y) }]));
}
