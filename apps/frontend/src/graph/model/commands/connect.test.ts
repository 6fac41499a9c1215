import { describe, expect, it } from 'vitest';
import type { Graph } from '../graph.ts';
import { constantNode, topicNode } from '../make-node.ts';
import { aGraphOf, aModule, ref, wiresIn } from '../testing/small-graph.ts';
import { applyCommand } from './apply-command.ts';

const modules = [
  aModule('a', { i: 'double' }, { o: 'double' }),
  aModule('b', { i: 'double', j: 'double' }, { o: 'double' }),
];

const connected = (graph: Graph, from: string, to: string, via?: string): Graph =>
  applyCommand(graph, {
    kind: 'connect',
    from: ref(graph, from),
    to: ref(graph, to),
    ...(via !== undefined && { via }),
  }).graph;

describe('connecting modules', () => {
  it('makes up a topic, and shares it among all who read it', () => {
    let graph = aGraphOf(modules);
    graph = connected(graph, 'a.o', 'b.i');
    graph = connected(graph, 'a.o', 'b.j');
    expect(wiresIn(graph)).toEqual(['a.o > b.i (/Test/a/o)', 'a.o > b.j (/Test/a/o)']);
  });

  it('creates an unused topic name', () => {
    const graph = connected(aGraphOf(modules, { 'b.j': '/Test/a/o' }), 'a.o', 'b.i');
    expect(wiresIn(graph)).toContain('a.o > b.i (/Test/a/o-2)');
  });

  it('goes over the topic that is there', () => {
    const graph = connected(aGraphOf(modules, { 'a.o': '/t' }), 'a.o', 'b.i');
    expect(wiresIn(graph)).toEqual(['a.o > topic:/t', 'topic:/t > b.i']);
  });

  it('shows a topic that two modules write', () => {
    let graph = aGraphOf(modules, { 'a.o': '/t', 'b.i': '/t' });
    expect(wiresIn(graph)).toEqual(['a.o > b.i (/t)']);
    graph = connected(graph, 'b.o', 'b.j', '/t');
    expect(wiresIn(graph)).toEqual([
      'a.o > topic:/t',
      'b.o > topic:/t',
      'topic:/t > b.i',
      'topic:/t > b.j',
    ]);
  });

  it('takes the place of the wire that was there', () => {
    let graph = aGraphOf(modules, { 'b.i': '/t' });
    graph = connected(graph, 'a.o', 'b.i');
    expect(wiresIn(graph)).toEqual(['a.o > b.i (/Test/a/o)']);
  });
});

describe('a constant at an input that has a value', () => {
  const plain = applyCommand(aGraphOf(modules, { 'b.i': { constantJson: '1' } }), {
    kind: 'add',
    nodes: [constantNode('constant:1', '2', { position: { x: 0, y: 0 } })],
  }).graph;
  const valueOf = (graph: Graph): unknown => {
    const node = graph.nodes.get('module:b');
    return node?.kind === 'module' ? node.constants.get('i') : undefined;
  };
  const wired = connected(plain, 'constant:1', 'b.i');

  it('takes the place of the value, and leaves an empty input when its wire goes', () => {
    expect(valueOf(wired)).toBeUndefined();
    expect(wiresIn(wired)).toEqual(['constant:1 > b.i']);
    const [wire = ''] = wired.wires.keys();
    const cut = applyCommand(wired, { kind: 'remove', wires: [wire] }).graph;
    expect(valueOf(cut)).toBeUndefined();
  });

  it('gives way to a value that is set', () => {
    const set = { kind: 'setConstant', node: 'module:b', input: 'i', json: '3' } as const;
    const { graph, inverse } = applyCommand(wired, set);
    expect(valueOf(graph)).toBe('3');
    expect(wiresIn(graph)).toEqual([]);
    expect(applyCommand(graph, inverse).graph).toEqual(wired);
  });

  it('comes with what is added', () => {
    const [wire] = wired.wires.values();
    const { graph } = applyCommand(plain, { kind: 'add', nodes: [], wires: [wire!] });
    expect(graph).toEqual(wired);
  });
});

describe('topics of wires', () => {
  const graph = aGraphOf(modules, { 'a.o': '/t', 'b.i': '/t', 'b.j': '/t' });
  const [wire = ''] = graph.wires.keys();

  it('get a node and lose it again', () => {
    const shown = applyCommand(graph, { kind: 'showTopic', wire }).graph;
    expect(wiresIn(shown)).toEqual(['a.o > topic:/t', 'topic:/t > b.i', 'topic:/t > b.j']);
    const hidden = applyCommand(shown, { kind: 'hideTopic', node: 'topic:/t' }).graph;
    expect(hidden).toEqual(graph);
  });

  it('get a node when they are dragged in', () => {
    const node = topicNode('/t', { position: { x: 1, y: 2 } });
    const shown = applyCommand(graph, { kind: 'add', nodes: [node] }).graph;
    expect(wiresIn(shown)).toEqual(['a.o > topic:/t', 'topic:/t > b.i', 'topic:/t > b.j']);
    expect(shown.nodes.get('topic:/t')).toEqual(node);
  });

  it('change for all that share them', () => {
    const changed = applyCommand(graph, { kind: 'setVia', wire, topic: '/u' }).graph;
    expect(wiresIn(changed)).toEqual(['a.o > b.i (/u)', 'a.o > b.j (/u)']);
  });

  it('become one when a topic is renamed to one that is there', () => {
    const two = aGraphOf(modules, { 'a.i': '/s', 'b.i': '/t' });
    const one = applyCommand(two, { kind: 'renameTopic', node: 'topic:/s', topic: '/t' }).graph;
    expect(wiresIn(one)).toEqual(['topic:/t > a.i', 'topic:/t > b.i']);
  });
});
