import type { Graph, Point } from '../model/graph.ts';
import { wiresOf } from '../model/wires-of.ts';

const COLUMN = 280;
const ROW = 190;

/** Where every node stands: as somebody put it, else in columns along the flow, below what is there. */
export function placesOf(graph: Graph): ReadonlyMap<string, Point> {
  const places = new Map<string, Point>();
  const loose: string[] = [];
  let top = 0;
  for (const { id, position, size } of graph.nodes.values()) {
    if (position === undefined) loose.push(id);
    else {
      places.set(id, position);
      top = Math.max(top, position.y + (size?.height ?? ROW));
    }
  }
  const columns = columnsOf(graph, loose);
  const filled = new Map<number, number>();
  for (const id of loose) {
    const column = columns.get(id) ?? 0;
    const row = filled.get(column) ?? 0;
    filled.set(column, row + 1);
    places.set(id, { x: column * COLUMN, y: top + row * ROW });
  }
  return places;
}

/** How many steps each node is away from where values come from; cycles are cut where they close. */
function columnsOf(graph: Graph, ids: readonly string[]): ReadonlyMap<string, number> {
  const columns = new Map<string, number>();
  const wanted = new Set(ids);
  const visiting = new Set<string>();
  function columnOf(id: string): number {
    const known = columns.get(id);
    if (known !== undefined) return known;
    if (visiting.has(id)) return 0;
    visiting.add(id);
    const before = wiresOf(graph, id)
      .in.map(({ from }) => from.node)
      .filter((node) => wanted.has(node));
    const column = before.length === 0 ? 0 : Math.max(...before.map(columnOf)) + 1;
    visiting.delete(id);
    columns.set(id, column);
    return column;
  }
  for (const id of ids) columnOf(id);
  return columns;
}
