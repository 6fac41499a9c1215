import type { Point } from '../graph.ts';
import type { LayoutGraph, LayoutNode } from './layout-graph.ts';

/** Gaps between columns, and between nodes of a column. */
export const COLUMN_GAP = 96;
export const ROW_GAP = 32;

/** Number of passes that align nodes vertically with their neighbours. */
const ROUNDS = 4;

/** Places nodes in columns so that wires lead to the right where possible. Simple, fast and deterministic. */
export function layeredLayout({ nodes, wires }: LayoutGraph): Map<string, Point> {
  const columns = columnsOf(nodes, wires);
  const neighbours = neighboursOf(nodes, wires);
  for (let round = 0; round < ROUNDS; round += 1) sortColumns(columns, neighbours);
  const places = new Map<string, Point>();
  const heights = columns.map((column) => heightOf(column));
  const tallest = Math.max(0, ...heights);
  let x = 0;
  columns.forEach((column, index) => {
    let y = Math.round((tallest - (heights[index] ?? 0)) / 2);
    for (const { id, height } of column) {
      places.set(id, { x, y });
      y += height + ROW_GAP;
    }
    x += Math.max(0, ...column.map(({ width }) => width)) + COLUMN_GAP;
  });
  return places;
}

const heightOf = (column: readonly LayoutNode[]): number =>
  column.reduce((sum, { height }) => sum + height, 0) + ROW_GAP * Math.max(0, column.length - 1);

/** Assigns each node to a column right of its sources, by the longest path; ignores wires that close a cycle. */
function columnsOf(nodes: LayoutGraph['nodes'], wires: LayoutGraph['wires']): LayoutNode[][] {
  const next = new Map<string, string[]>();
  for (const { from, to } of wires) next.set(from, [...(next.get(from) ?? []), to]);
  const order = topologicalOrder(nodes, next);
  const rank = new Map(order.map((id, index) => [id, index]));
  const column = new Map<string, number>();
  for (const id of order) {
    for (const target of next.get(id) ?? []) {
      if ((rank.get(target) ?? 0) <= (rank.get(id) ?? 0)) continue;
      column.set(target, Math.max(column.get(target) ?? 0, (column.get(id) ?? 0) + 1));
    }
  }
  pullSources(wires, column);
  const columns: LayoutNode[][] = [];
  for (const node of nodes) (columns[column.get(node.id) ?? 0] ??= []).push(node);
  return columns.filter((one) => one !== undefined);
}

/** Moves nodes without sources next to their targets, instead of to the far left. */
function pullSources(wires: LayoutGraph['wires'], column: Map<string, number>): void {
  const fed = new Set(wires.map(({ to }) => to));
  const nearest = new Map<string, number>();
  for (const { from, to } of wires) {
    if (fed.has(from)) continue;
    nearest.set(from, Math.min(nearest.get(from) ?? Infinity, column.get(to) ?? 0));
  }
  for (const [id, target] of nearest) column.set(id, Math.max(0, target - 1));
}

/** Topological order; depth first, without recursion. */
function topologicalOrder(
  nodes: LayoutGraph['nodes'],
  next: ReadonlyMap<string, readonly string[]>,
): string[] {
  const seen = new Set<string>();
  const order: string[] = [];
  for (const { id: root } of nodes) {
    if (seen.has(root)) continue;
    seen.add(root);
    const stack = [{ id: root, index: 0 }];
    for (let top = stack.at(-1); top !== undefined; top = stack.at(-1)) {
      const target = next.get(top.id)?.[top.index++];
      if (target === undefined) {
        order.push(top.id);
        stack.pop();
      } else if (!seen.has(target)) {
        seen.add(target);
        stack.push({ id: target, index: 0 });
      }
    }
  }
  return order.reverse();
}

function neighboursOf(
  nodes: LayoutGraph['nodes'],
  wires: LayoutGraph['wires'],
): ReadonlyMap<string, readonly string[]> {
  const neighbours = new Map<string, string[]>(nodes.map(({ id }) => [id, []]));
  for (const { from, to } of wires) {
    neighbours.get(from)?.push(to);
    neighbours.get(to)?.push(from);
  }
  return neighbours;
}

/** Sorts each column by the mean height of the neighbours, to reduce crossings. */
function sortColumns(
  columns: LayoutNode[][],
  neighbours: ReadonlyMap<string, readonly string[]>,
): void {
  const heights = new Map<string, number>();
  for (const column of columns) {
    column.forEach(({ id }, index) => heights.set(id, index / column.length));
  }
  for (const column of columns) {
    const means = new Map(
      column.map(({ id }) => {
        const around = neighbours.get(id) ?? [];
        const sum = around.reduce((total, other) => total + (heights.get(other) ?? 0), 0);
        return [id, around.length === 0 ? (heights.get(id) ?? 0) : sum / around.length];
      }),
    );
    column.sort((a, b) => (means.get(a.id) ?? 0) - (means.get(b.id) ?? 0));
    column.forEach(({ id }, index) => heights.set(id, index / column.length));
  }
}
