import { expect, it } from 'vitest';
import { aGraphOf, aModule } from '../model/testing/small-graph.ts';
import type { Graph, Point } from '../model/graph.ts';
import { drawUnits } from './draw-units.ts';
import { topicsOf } from './topics-in-graph.ts';

function placed(graph: Graph, places: Readonly<Record<string, Point>>): Graph {
  const nodes = [...graph.nodes].map(([id, node]) => [id, { ...node, position: places[id] }]);
  return { ...graph, nodes: new Map(nodes as never) };
}

const graph = placed(
  aGraphOf(
    [
      aModule('a', { in: 'double' }, { out: 'double' }),
      aModule('b', { in: 'double' }, { out: 'double' }),
      aModule('c', { in: 'double' }),
    ],
    { 'a.in': '/first', 'a.out': '/second', 'b.in': '/second', 'c.in': '/second' },
  ),
  {
    'module:c': { x: 0, y: 900 },
    'module:b': { x: 300, y: 0 },
    'module:a': { x: 0, y: 20 },
    'topic:/first': { x: -300, y: 10 },
  },
);

it('draws each topic of a graph once, with the node it comes from', () => {
  const units = drawUnits(graph);
  expect(units.flatMap(({ topics }) => topics).sort()).toEqual([...topicsOf(graph)].sort());
  expect(units.find(({ module }) => module === 'a')).toEqual({
    node: 'module:a',
    topics: ['/second'],
    shownAt: ['module:a', 'module:b', 'module:c'],
    module: 'a',
  });
});

it('draws a topic while the node that writes it is visible', () => {
  const written = aGraphOf([aModule('a', {}, { out: 'double' })], { 'a.out': '/last' });
  const unit = drawUnits(written).find(({ node }) => node === 'topic:/last');
  expect(unit?.shownAt).toEqual(['topic:/last', 'module:a']);
});

it('draws nodes that lie side by side one after the other', () => {
  expect(drawUnits(graph).map(({ node }) => node)).toEqual([
    'topic:/first',
    'module:a',
    'module:b',
    'module:c',
  ]);
});
