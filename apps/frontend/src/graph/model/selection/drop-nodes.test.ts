import { describe, expect, it } from 'vitest';
import { applyCommand } from '../commands/apply-command.ts';
import { perform, startEditing, undo } from '../commands/edit-state.ts';
import type { Graph } from '../graph.ts';
import { frameNode, moduleNode } from '../make-node.ts';
import { aGraphOf, aModule, wiresIn } from '../testing/small-graph.ts';
import { dropNodes, type NodeDrop } from './drop-nodes.ts';
import { areaUnder, frameAround, resizeFrame } from './frames.ts';
import { moveTogether } from './move.ts';
import { withContents } from '../nesting.ts';
import { addPoint, movePoint, removePoint } from './wire-points.ts';

const number = { i: 'double' };
const chain = aGraphOf(
  [aModule('a', number, { o: 'double' }), aModule('b', number, { o: 'double' })],
  { 'a.i': '/in', 'a.o': '/ab', 'b.i': '/ab', 'b.o': '/out' },
);
const between = [...chain.wires.values()].find(({ via }) => via === '/ab')!;
const box = (id: string, x = 0, y = 0) => ({ id, x, y, width: 100, height: 50 });
const frame = { id: 'frame:f', x: -50, y: -50, width: 400, height: 300 };
const drop: NodeDrop = {
  boxes: [],
  frames: [],
  by: { x: 10, y: 0 },
  isDetached: false,
  on: undefined,
};
const framed = applyCommand(chain, {
  kind: 'add',
  nodes: [frameNode('frame:f', 'F', { position: { x: -50, y: -50 } })],
}).graph;
const frameOf = (graph: Graph, id: string): string | undefined => graph.nodes.get(id)?.frame;
const after = (graph: Graph, one: Partial<NodeDrop>): Graph =>
  applyCommand(graph, dropNodes(graph, { ...drop, ...one })).graph;

describe('what a drag did', () => {
  it('puts a node into the frame it lies in, and takes it out again', () => {
    const inside = after(framed, { boxes: [box('module:a')], frames: [frame] });
    expect(frameOf(inside, 'module:a')).toBe('frame:f');
    const outside = after(inside, { boxes: [box('module:a', 900)], frames: [frame] });
    expect(frameOf(outside, 'module:a')).toBeUndefined();
    expect(outside.nodes.get('module:a')?.position).toEqual({ x: 900, y: 0 });
  });

  it('leaves what moved with its frame in it', () => {
    const inside = after(framed, { boxes: [box('module:a')], frames: [frame] });
    const away = { ...frame, x: 2000 };
    const moved = after(inside, { boxes: [away, box('module:a', 3000)], frames: [away] });
    expect(frameOf(moved, 'module:a')).toBe('frame:f');
  });

  it('inserts a node on a wire, as one step that can be undone', () => {
    const more = applyCommand(chain, {
      kind: 'add',
      nodes: [moduleNode(aModule('m', number, { o: 'double' }))],
    }).graph;
    const command = dropNodes(more, {
      ...drop,
      boxes: [box('module:m')],
      on: { wire: between.id, leg: 1 },
    });
    const state = perform(startEditing(more), command);
    expect(wiresIn(state.graph)).toEqual(
      expect.arrayContaining(['a.o > m.i (/ab)', 'm.o > b.i (/Test/m/o)']),
    );
    expect(state.past.map(({ label }) => label)).toEqual(['Insert m on a wire']);
    expect(undo(state).graph).toEqual(more);
  });

  it('leads both halves of a wire through the points it had', () => {
    const points = [1, 2, 3].map((x) => ({ x, y: 0 }));
    const led = applyCommand(chain, { kind: 'reroute', wire: between.id, points }).graph;
    const more = applyCommand(led, {
      kind: 'add',
      nodes: [moduleNode(aModule('m', number, { o: 'double' }))],
    }).graph;
    const graph = after(more, { boxes: [box('module:m')], on: { wire: between.id, leg: 2 } });
    const pointsOf = (to: string) =>
      [...graph.wires.values()].find((wire) => wire.to.node === to)?.points;
    expect([pointsOf('module:m'), pointsOf('module:b')]).toEqual([
      points.slice(0, 2),
      points.slice(2),
    ]);
  });

  it('takes a node off its wires, and inserts it elsewhere', () => {
    const free = after(chain, { boxes: [box('module:b')], isDetached: true });
    expect(wiresIn(free).join()).not.toContain('b.');
    const first = [...chain.wires.values()].find(({ to }) => to.node === 'module:a')!;
    const moved = after(chain, {
      boxes: [box('module:b')],
      isDetached: true,
      on: { wire: first.id, leg: 0 },
    });
    expect(wiresIn(moved)).toEqual(expect.arrayContaining(['topic:/in > b.i']));
    expect(moved.wires.has(first.id)).toBe(false);
  });

  it('takes along the points of wires between nodes that move', () => {
    const led = applyCommand(chain, addPoint(between, 0, { x: 50, y: 60 })).graph;
    const ids = withContents(led, ['module:a', 'module:b']);
    const places = new Map([...ids].map((id) => [id, { x: 10, y: 0 }]));
    const both = applyCommand(led, moveTogether(led, places, { x: 10, y: -5 })).graph;
    expect(both.wires.get(between.id)?.points).toEqual([{ x: 60, y: 55 }]);
    const one = applyCommand(
      led,
      moveTogether(led, new Map([['module:a', { x: 1, y: 1 }]]), { x: 1, y: 1 }),
    ).graph;
    expect(one.wires.get(between.id)?.points).toEqual([{ x: 50, y: 60 }]);
  });
});

describe('frames', () => {
  it('lies around nodes, with room for a title', () => {
    const command = frameAround(chain, [box('module:a'), box('module:b', 200, 100)], 'frame:n');
    const graph = applyCommand(chain, command).graph;
    expect(graph.nodes.get('frame:n')).toMatchObject({
      position: { x: -24, y: -36 },
      size: { width: 348, height: 210 },
    });
    expect(frameOf(graph, 'module:b')).toBe('frame:n');
  });

  it('is the smallest one where several lie', () => {
    const small = { id: 'frame:s', x: 0, y: 0, width: 110, height: 60 };
    expect(areaUnder(box('module:a'), [frame, small])?.id).toBe('frame:s');
    expect(areaUnder(box('module:a', 4000), [frame, small])).toBeUndefined();
  });

  it('has what lies in it when it was resized', () => {
    const node = framed.nodes.get('frame:f');
    if (node?.kind !== 'frame') throw new Error('no frame');
    const boxes = [box('module:a'), box('module:b', 500), frame];
    const wide = applyCommand(
      framed,
      resizeFrame(framed, node, { ...frame, width: 900 }, boxes),
    ).graph;
    expect([frameOf(wide, 'module:a'), frameOf(wide, 'module:b')]).toEqual(['frame:f', 'frame:f']);
    const narrow = applyCommand(wide, resizeFrame(wide, node, { ...frame, width: 120 }, boxes));
    expect(frameOf(narrow.graph, 'module:b')).toBeUndefined();
  });
});

describe('points of wires', () => {
  it('are added, moved and removed', () => {
    let graph = chain;
    const wire = () => graph.wires.get(between.id)!;
    const run = (command: Parameters<typeof applyCommand>[1]): void => {
      graph = applyCommand(graph, command).graph;
    };
    run(addPoint(wire(), 0, { x: 1, y: 1 }));
    run(addPoint(wire(), 1, { x: 2, y: 2 }));
    run(addPoint(wire(), 1, { x: 3, y: 3 }));
    run(movePoint(wire(), 1, { x: 9, y: 9 }));
    run(removePoint(wire(), 0));
    expect(wire().points).toEqual([
      { x: 9, y: 9 },
      { x: 2, y: 2 },
    ]);
  });
});
