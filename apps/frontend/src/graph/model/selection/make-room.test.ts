import { describe, expect, it } from 'vitest';
import { perform, startEditing, undo } from '../commands/edit-state.ts';
import type { Graph, GraphNode, Point } from '../graph.ts';
import { moduleNode } from '../make-node.ts';
import { aGraphOf, aModule } from '../testing/small-graph.ts';
import type { Box } from './arrange.ts';
import { insertOnWire } from './insert.ts';
import { WIRE_GAP } from './make-room.ts';

const number = { i: 'double' };
const out = { o: 'double' };
const graph = aGraphOf(
  [aModule('a', number, out), aModule('b', number, out), aModule('c', number), aModule('d')],
  { 'a.o': '/ab', 'b.i': '/ab', 'b.o': '/bc', 'c.i': '/bc' },
);
const wire = [...graph.wires.values()].find(({ via }) => via === '/ab')!;
const SIZE = { width: 180, height: 100 };
const boxesAt = (places: Readonly<Record<string, Point>>): Box[] =>
  Object.entries(places).map(([name, at]) => ({ id: `module:${name}`, ...at, ...SIZE }));
const near = boxesAt({
  a: { x: 0, y: 0 },
  b: { x: 280, y: 0 },
  c: { x: 560, y: 0 },
  d: { x: 0, y: 400 },
});
const inserted = moduleNode(aModule('m', number, out));

/** Inserts `m` into the wire from `a` to `b`. */
function insert(boxes: readonly Box[], at: Point): { after: Graph; before: Graph } {
  const node: GraphNode = { ...inserted, position: at };
  const command = insertOnWire(graph, wire.id, node, 0, [
    ...boxes,
    { id: node.id, ...at, ...SIZE },
  ])!;
  const state = perform(startEditing(graph), command);
  return { after: state.graph, before: undo(state).graph };
}
const xOf = (of: Graph, name: string): number | undefined =>
  of.nodes.get(`module:${name}`)?.position?.x;

describe('a node that is inserted on a wire', () => {
  it('moves what is downstream to the right and leaves the rest', () => {
    const { after } = insert(near, { x: 140, y: 20 });
    const [m, b, c] = ['m', 'b', 'c'].map((name) => xOf(after, name));
    expect(m).toBe(180 + WIRE_GAP);
    expect(b).toBe(m! + SIZE.width + WIRE_GAP);
    expect(c! - b!).toBe(280);
    expect(after.nodes.get('module:d')?.position).toEqual({ x: 0, y: 400 });
  });

  it('is one step of undo', () => {
    const { before } = insert(near, { x: 140, y: 20 });
    expect(before.nodes).toEqual(graph.nodes);
    expect(before.wires).toEqual(graph.wires);
  });

  it('leaves everything where there is room', () => {
    const far = boxesAt({ a: { x: 0, y: 0 }, b: { x: 900, y: 0 } });
    const { after } = insert(far, { x: 400, y: 20 });
    expect(after.nodes.get('module:m')?.position).toEqual({ x: 400, y: 20 });
    expect(xOf(after, 'b')).toBeUndefined();
  });

  it('pushes what the moved nodes would cover', () => {
    const { after } = insert(
      [...near, ...boxesAt({ d: { x: 800, y: 30 } })].filter(
        ({ id, x }) => id !== 'module:d' || x === 800,
      ),
      { x: 140, y: 20 },
    );
    expect(xOf(after, 'd')! - xOf(after, 'c')!).toBe(240);
  });

  it('goes below what lies between the ends', () => {
    const boxes = boxesAt({ a: { x: 0, y: 0 }, b: { x: 900, y: 0 }, d: { x: 380, y: 10 } });
    const { after } = insert(boxes, { x: 400, y: 60 });
    expect(after.nodes.get('module:m')?.position).toEqual({ x: 400, y: 130 });
  });

  it('moves nothing where the wire goes back', () => {
    const { after } = insert(boxesAt({ a: { x: 400, y: 0 }, b: { x: 0, y: 0 } }), {
      x: 100,
      y: 90,
    });
    expect(after.nodes.get('module:m')?.position).toEqual({ x: 100, y: 90 });
    expect(xOf(after, 'b')).toBeUndefined();
  });
});
