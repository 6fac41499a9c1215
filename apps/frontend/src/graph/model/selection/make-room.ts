import type { GraphCommand } from '../commands/graph-command.ts';
import type { Graph, Point, Wire } from '../graph.ts';
import { wiresOf } from '../wires-of.ts';
import { bounds, type Box } from './arrange.ts';
import { moveTogether } from './move.ts';
import { withContents } from '../nesting.ts';

/** Gap between connected nodes, wide enough for the rate of the wire. */
export const WIRE_GAP = 90;
/** Vertical gap between nodes. */
const GAP = 20;

/** Position of a node inserted into a wire, and the nodes that move aside. */
export interface Room {
  readonly position: Point;
  /** Distance by which the nodes behind it move to the right. */
  readonly shift: number;
  readonly commands: readonly GraphCommand[];
}

/**
 * Makes space for a node in a wire: nodes downstream move to the right with their frames, and push nodes that they
 * would cover. Nothing moves for wires that lead back.
 * @param box of the node at its position
 * @param boxes drawn boxes of all nodes
 */
export function makeRoom(graph: Graph, wire: Wire, box: Box, boxes: readonly Box[]): Room {
  const others = boxes.filter(({ id }) => id !== box.id);
  const from = others.find(({ id }) => id === wire.from.node);
  const to = others.find(({ id }) => id === wire.to.node);
  const start = from && from.x + from.width;
  if (start === undefined || to === undefined || to.x < start)
    return { position: { x: box.x, y: box.y }, shift: 0, commands: [] };
  const least = start + WIRE_GAP;
  const most = to.x - WIRE_GAP - box.width;
  const x = Math.max(least, Math.min(box.x, most));
  const shift = Math.max(0, least - most);
  const isFrame = ({ id }: Box): boolean => graph.nodes.get(id)?.kind === 'frame';
  const solid = others.filter((one) => !isFrame(one));
  const moved = shift === 0 ? new Set<string>() : pushed(graph, wire, start, shift, solid);
  const staying = solid.filter(({ id }) => !moved.has(id) && id !== wire.from.node);
  const position = { x, y: freeHeight({ ...box, x }, staying) };
  return { position, shift, commands: moveAll(graph, moved, shift, others) };
}

/** The nodes downstream of a wire to the right of its start, and all that they would cover. */
function pushed(
  graph: Graph,
  wire: Wire,
  start: number,
  shift: number,
  boxes: readonly Box[],
): Set<string> {
  const right = new Map(boxes.filter(({ x }) => x >= start).map((box) => [box.id, box]));
  right.delete(wire.from.node);
  const moved = new Set<string>();
  const open = [wire.to.node];
  for (let id = open.pop(); id !== undefined; id = open.pop()) {
    const own = right.get(id);
    if (own === undefined || moved.has(id)) continue;
    moved.add(id);
    open.push(...wiresOf(graph, id).out.map(({ to }) => to.node));
    const way = { ...own, x: own.x + shift };
    for (const other of right.values()) {
      if (!moved.has(other.id) && overlap(way, other) && !overlap(own, other)) open.push(other.id);
    }
  }
  return moved;
}

/** Returns the nearest free position, above or below the obstacles. */
function freeHeight(box: Box, others: readonly Box[]): number {
  const go = (way: 1 | -1): number => {
    let { y } = box;
    for (let tries = 0; tries <= others.length; tries += 1) {
      const hit = others.find((other) => overlap({ ...box, y }, other));
      if (hit === undefined) break;
      y = way > 0 ? hit.y + hit.height + GAP : hit.y - box.height - GAP;
    }
    return y;
  };
  const [up, down] = [go(-1), go(1)];
  return box.y - up < down - box.y ? up : down;
}

function moveAll(
  graph: Graph,
  moved: ReadonlySet<string>,
  shift: number,
  boxes: readonly Box[],
): GraphCommand[] {
  if (moved.size === 0) return [];
  const all = new Set(moved);
  const grown: GraphCommand[] = [];
  for (const frame of boxes) {
    if (graph.nodes.get(frame.id)?.kind !== 'frame') continue;
    const contents = [...withContents(graph, [frame.id])].filter((id) => id !== frame.id);
    const inside = boxes.filter(({ id }) => contents.includes(id) && moved.has(id));
    if (inside.length === 0) continue;
    const nodes = contents.filter((id) => graph.nodes.get(id)?.kind !== 'frame');
    if (nodes.every((id) => moved.has(id))) {
      all.add(frame.id);
      continue;
    }
    const { x, y, width, height } = frame;
    const reach = bounds(inside.map((box) => ({ ...box, x: box.x + shift + GAP })));
    const size = { width: Math.max(width, reach.x + reach.width - x), height };
    grown.push({ kind: 'resize', node: frame.id, size, position: { x, y } });
  }
  const way = { x: shift, y: 0 };
  const places = new Map(
    boxes.flatMap(({ id, x, y }) => {
      if (all.has(id)) return [[id, { x: x + shift, y }] as const];
      // The layout would move nodes without a stored position.
      return graph.nodes.get(id)?.position === undefined ? [[id, { x, y }] as const] : [];
    }),
  );
  const going = new Map([...places].filter(([id]) => all.has(id)));
  const pinned = new Map([...places].filter(([id]) => !all.has(id)));
  return [
    ...(pinned.size > 0 ? [{ kind: 'move', positions: pinned } as const] : []),
    moveTogether(graph, going, way),
    ...grown,
  ];
}

const overlap = (a: Box, b: Box): boolean =>
  a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
