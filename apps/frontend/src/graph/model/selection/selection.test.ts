import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { applyCommand } from '../commands/apply-command.ts';
import type { GraphCommand } from '../commands/graph-command.ts';
import { graphOf } from '../graph-of.ts';
import type { Graph } from '../graph.ts';
import { commentNode, frameNode, moduleNode } from '../make-node.ts';
import { arbitrarySession } from '../testing/arbitrary-session.ts';
import { aGraphOf, aModule, wiresIn } from '../testing/small-graph.ts';
import { align, distribute, snap, snapToOthers } from './arrange.ts';
import { copyText, duplicate, paste, type Pasted } from './clipboard.ts';
import { insertionOf, insertOnWire, wiresToInsertOn } from './insert.ts';
import { detach, removeAndReconnect } from './reconnect.ts';

const after = (graph: Graph, command: GraphCommand | undefined): Graph =>
  applyCommand(graph, command!).graph;
const counter = (): (() => string) => {
  let count = 0;
  return () => `new${(count += 1)}`;
};

const number = { i: 'double', cutoff: 'double' };
const chain = aGraphOf(
  [
    aModule('a', number, { o: 'double' }),
    aModule('b', number, { o: 'double', text: 'string' }),
    aModule('c', number, { o: 'double' }),
  ],
  { 'a.i': '/in', 'a.o': '/ab', 'b.i': '/ab', 'b.o': '/bc', 'c.i': '/bc', 'c.o': '/out' },
);

describe('delete and reconnect', () => {
  it('wires what fed a module to what it fed', () => {
    expect(wiresIn(after(chain, removeAndReconnect(chain, ['module:b'])))).toEqual([
      'a.o > c.i (/ab)',
      'c.o > topic:/out',
      'topic:/in > a.i',
    ]);
  });

  it('goes over several modules that go together', () => {
    const command = removeAndReconnect(chain, ['module:a', 'module:b']);
    expect(wiresIn(after(chain, command))).toEqual(['c.o > topic:/out', 'topic:/in > c.i']);
  });

  it('leaves open what does not fit', () => {
    const graph = aGraphOf(
      [aModule('a', { i: 'string' }, { o: 'double' }), aModule('b', { i: 'double' })],
      { 'a.i': '/text', 'a.o': '/n', 'b.i': '/n' },
    );
    expect(wiresIn(after(graph, removeAndReconnect(graph, ['module:a'])))).toEqual([]);
  });

  it('makes a wire of a topic that goes, and keeps its name', () => {
    const shown = after(chain, { kind: 'showTopic', wire: [...chain.wires.keys()][1]! });
    expect(shown.nodes.has('topic:/ab')).toBe(true);
    const command = removeAndReconnect(shown, ['topic:/ab']);
    expect(wiresIn(after(shown, command))).toEqual(wiresIn(chain));
  });

  it('detaches and keeps the module', () => {
    const graph = after(chain, detach(chain, ['module:b']));
    expect(graph.nodes.has('module:b')).toBe(true);
    expect(wiresIn(graph)).toContain('a.o > c.i (/ab)');
    expect(wiresIn(graph).join()).not.toContain('b.');
  });
});

describe('insert on a wire', () => {
  const middle = moduleNode(aModule('m', { t: 'string', i: 'double' }, { o: 'double' }));
  const wire = [...chain.wires.values()].find(({ via }) => via === '/ab')!;

  it('leads the wire through the ports that fit', () => {
    expect(insertionOf(chain, wire, middle)).toEqual({ input: 'in:i', output: 'out:o' });
    expect(wiresIn(after(chain, insertOnWire(chain, wire.id, middle)))).toEqual(
      expect.arrayContaining(['a.o > m.i (/ab)', 'm.o > b.i (/Test/m/o)']),
    );
  });

  it('does nothing where it does not fit', () => {
    const text = moduleNode(aModule('t', { i: 'string' }, { o: 'string' }));
    expect(insertOnWire(chain, wire.id, text)).toBeUndefined();
    expect(wiresToInsertOn(chain, text)).toEqual([]);
    expect(wiresToInsertOn(chain, middle).map(({ to }) => to.node)).toEqual([
      'module:a',
      'module:b',
      'module:c',
      'topic:/out',
    ]);
  });
});

describe('copy and paste', () => {
  const pasted = (one: Pasted): Extract<Pasted, { kind: 'nodes' }> => {
    if (one.kind !== 'nodes') throw new Error(JSON.stringify(one));
    return one;
  };

  it('keeps inner wires, with topics of their own', () => {
    const copy = duplicate(chain, ['module:a', 'module:b'], counter());
    const graph = after(chain, copy?.command);
    expect(copy?.ids).toEqual(['module:new1', 'module:new2']);
    expect(wiresIn(graph)).toEqual([...wiresIn(chain), 'new1.o > new2.i (/ab-2)'].sort());
  });

  it('works across sessions, with topics, comments and frames', () => {
    const nodes = [
      frameNode('frame:f', 'Phones', { position: { x: 0, y: 0 } }),
      commentNode('comment:c', 'Note', { frame: 'frame:f', position: { x: 10, y: 20 } }),
    ];
    const source = after(chain, { kind: 'add', nodes });
    const text = copyText(source, ['frame:f', 'module:a', 'topic:/in']);
    const empty = aGraphOf([]);
    const position = { x: 100, y: 100 };
    const graph = after(empty, pasted(paste(empty, text, { uuid: counter(), position })).command);
    expect(wiresIn(graph)).toEqual(['topic:/in > new1.i']);
    expect(graph.nodes.get('frame:new2')).toMatchObject({ title: 'Phones', position });
    expect(graph.nodes.get('comment:new3')).toMatchObject({
      text: 'Note',
      frame: 'frame:new2',
      position: { x: 110, y: 120 },
    });
  });

  it('says what a text is that is none', () => {
    expect(paste(chain, 'hello', { uuid: counter() })).toEqual({ kind: 'foreign' });
    expect(
      paste(chain, '{"format":"ubi-interact.nodes","version":9}', { uuid: counter() }),
    ).toEqual({
      kind: 'broken',
      reason:
        'The text has version 9; this page reads version 1. Create it with the same version of Ubi-Interact.',
    });
    const broken =
      '{"format":"ubi-interact.nodes","version":1,"nodes":[{"kind":"module","id":"a","module":3}],"wires":[]}';
    expect(paste(chain, broken, { uuid: counter() })).toEqual({
      kind: 'broken',
      reason: 'The text cannot be read: nodes[0].module is damaged: it must be an object, got 3.',
    });
  });

  it('puts in nothing that the graph cannot have, whatever the text says', () => {
    fc.assert(
      fc.property(fc.jsonValue(), fc.jsonValue(), (nodes, wires) => {
        const text = JSON.stringify({ format: 'ubi-interact.nodes', version: 1, nodes, wires });
        const result = paste(chain, text, { uuid: counter() });
        if (result.kind === 'nodes') after(chain, result.command);
      }),
    );
    const text = JSON.stringify({
      format: 'ubi-interact.nodes',
      version: 1,
      nodes: [{ kind: 'module', id: 'a', module: {} }],
      wires: [{ from: ['a', 'out:x'], to: ['a', 'in:x'] }],
    });
    const result = pasted(paste(chain, text, { uuid: counter() }));
    expect(after(chain, result.command).wires).toEqual(chain.wires);
  });

  it('pastes all of any graph', () => {
    fc.assert(
      fc.property(arbitrarySession, (session) => {
        const graph = graphOf(session);
        const empty = aGraphOf([]);
        const text = copyText(graph, graph.nodes.keys());
        const result = pasted(paste(empty, text, { uuid: counter() }));
        expect(after(empty, result.command).nodes.size).toBe(graph.nodes.size);
      }),
    );
  });
});

describe('arranging', () => {
  const boxes = [
    { id: 'a', x: 0, y: 0, width: 10, height: 10 },
    { id: 'b', x: 50, y: 5, width: 20, height: 30 },
    { id: 'c', x: 100, y: 91, width: 40, height: 10 },
  ];

  it.each([
    ['left', { b: [0, 5], c: [0, 91] }],
    ['center', { a: [65, 0], b: [60, 5], c: [50, 91] }],
    ['right', { a: [130, 0], b: [120, 5] }],
    ['top', { b: [50, 0], c: [100, 0] }],
    ['middle', { a: [0, 46], b: [50, 36], c: [100, 46] }],
    ['bottom', { a: [0, 91], b: [50, 71] }],
  ] as const)('aligns %s', (alignment, places) => {
    const found = [...align(boxes, alignment)].map(([id, { x, y }]) => [id, [x, y]]);
    expect(Object.fromEntries(found)).toEqual(places);
  });

  it('makes gaps equal', () => {
    expect([...distribute(boxes, 'x')]).toEqual([['b', { x: 45, y: 5 }]]);
    expect([...distribute(boxes, 'y')]).toEqual([['b', { x: 50, y: 36 }]]);
    expect(distribute(boxes.slice(0, 2), 'x').size).toBe(0);
  });

  it('snaps to a grid and to others', () => {
    expect(snap({ x: 13, y: -3 }, 8)).toEqual({ x: 16, y: 0 });
    const box = { id: 'd', x: 47, y: 300, width: 10, height: 10 };
    expect(snapToOthers(box, boxes, 4)).toEqual({
      point: { x: 50, y: 300 },
      guides: [{ axis: 'x', at: 50 }],
    });
  });
});
