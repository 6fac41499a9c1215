import type { ELK, ElkNode } from 'elkjs/lib/elk-api';
import type { Point } from '../graph.ts';
import { COLUMN_GAP, ROW_GAP } from './layered-layout.ts';
import type { LayoutGraph } from './layout-graph.ts';

const OPTIONS: Readonly<Record<string, string>> = {
  'elk.algorithm': 'layered',
  'elk.direction': 'RIGHT',
  'elk.spacing.nodeNode': String(ROW_GAP),
  'elk.layered.spacing.nodeNodeBetweenLayers': String(COLUMN_GAP),
  'elk.spacing.componentComponent': String(2 * ROW_GAP),
  'elk.layered.nodePlacement.strategy': 'NETWORK_SIMPLEX',
  // Keeps the result deterministic, and close to the order of lists.
  'elk.layered.considerModelOrder.strategy': 'NODES_AND_EDGES',
  'elk.randomSeed': '1',
};

/** Lays out with the layered algorithm of ELK (Sugiyama and others, 1981). */
export async function elkLayout(
  elk: Pick<ELK, 'layout'>,
  { nodes, wires }: LayoutGraph,
): Promise<Map<string, Point>> {
  // ELK restricts the characters of ids.
  const idOf = new Map(nodes.map(({ id }, index) => [id, `n${index}`]));
  const root: ElkNode = {
    id: 'root',
    layoutOptions: { ...OPTIONS },
    children: nodes.map(({ id, width, height }) => ({ id: idOf.get(id)!, width, height })),
    edges: wires.flatMap(({ from, to }, index) => {
      const [source, target] = [idOf.get(from), idOf.get(to)];
      if (source === undefined || target === undefined) return [];
      return [{ id: `e${index}`, sources: [source], targets: [target] }];
    }),
  };
  const { children = [] } = await elk.layout(root);
  return new Map(
    nodes.map(({ id }, index) => {
      const { x = 0, y = 0 } = children[index] ?? {};
      return [id, { x: Math.round(x), y: Math.round(y) }];
    }),
  );
}
