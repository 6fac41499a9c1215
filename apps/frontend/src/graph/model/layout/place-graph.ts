import type { Graph, GraphNode, Point, Size } from '../graph.ts';
import { bounds } from '../selection/arrange.ts';
import { COLUMN_GAP, layeredLayout, ROW_GAP } from './layered-layout.ts';
import { layoutGraphOf, onGrid, usualSize } from './layout-graph.ts';
import type { Layouter } from './worker-layouter.ts';

/** Options of a layout. */
export interface LayoutOptions {
  /** Size of a drawn node; default: an estimate. */
  readonly sizeOf?: (node: GraphNode) => Size;
  /** Lays out only these nodes, around their current centre; default: all. */
  readonly only?: ReadonlySet<string>;
  /** Grid of positions; default 8. */
  readonly grid?: number;
}

/**
 * Returns positions for all nodes in the data flow, with wires leading to the right.
 * @param layouter such as `workerLayouter`; when it fails, `layeredLayout` is used
 */
export async function layoutGraph(
  graph: Graph,
  layouter: Layouter,
  options: LayoutOptions = {},
): Promise<Map<string, Point>> {
  const { sizeOf = usualSize, only, grid = 8 } = options;
  const wanted = (node: GraphNode): boolean => only === undefined || only.has(node.id);
  const layout = layoutGraphOf(graph, sizeOf, wanted);
  if (layout.nodes.length === 0) return new Map();
  const places = await layouter(layout).catch(() => layeredLayout(layout));
  const whole = only === undefined ? places : aroundTheSameMiddle(graph, places, sizeOf);
  return onGrid(whole, grid);
}

/**
 * Places nodes without a position, synchronously: lays out a graph without any position, otherwise puts new nodes below
 * the existing ones.
 */
export function placeNew(graph: Graph, sizeOf: (node: GraphNode) => Size = usualSize): Graph {
  const homeless = [...graph.nodes.values()].filter(({ position }) => position === undefined);
  if (homeless.length === 0) return graph;
  const isNew = new Set(homeless.map(({ id }) => id));
  const layout = layoutGraphOf(graph, sizeOf, ({ id }) => isNew.has(id));
  const placed = [...graph.nodes.values()].flatMap((node) =>
    node.position === undefined ? [] : [{ ...node.position, ...sizeOf(node) }],
  );
  const around = bounds(placed);
  const by =
    placed.length === 0
      ? { x: 0, y: 0 }
      : { x: around.x, y: around.y + around.height + 2 * ROW_GAP };
  const nodes = new Map(graph.nodes);
  const places = onGrid(layeredLayout(layout), 8);
  let strayX = by.x;
  const strayY = by.y - (placed.length === 0 ? COLUMN_GAP + 2 * ROW_GAP : 0);
  for (const node of homeless) {
    const place = places.get(node.id);
    if (place !== undefined) {
      nodes.set(node.id, { ...node, position: { x: place.x + by.x, y: place.y + by.y } });
      continue;
    }
    // Comments and frames in a row.
    nodes.set(node.id, { ...node, position: { x: strayX, y: strayY } });
    strayX += sizeOf(node).width + ROW_GAP;
  }
  return { ...graph, nodes };
}

function aroundTheSameMiddle(
  graph: Graph,
  places: ReadonlyMap<string, Point>,
  sizeOf: (node: GraphNode) => Size,
): Map<string, Point> {
  const boxes = (placeOf: (node: GraphNode) => Point | undefined): (Point & Size)[] =>
    [...places.keys()].flatMap((id) => {
      const node = graph.nodes.get(id);
      const place = node && placeOf(node);
      return node && place ? [{ ...place, ...sizeOf(node) }] : [];
    });
  const before = bounds(boxes(({ position }) => position));
  const after = bounds(boxes(({ id }) => places.get(id)));
  const x = before.x + before.width / 2 - after.x - after.width / 2;
  const y = before.y + before.height / 2 - after.y - after.height / 2;
  return new Map([...places].map(([id, place]) => [id, { x: place.x + x, y: place.y + y }]));
}
