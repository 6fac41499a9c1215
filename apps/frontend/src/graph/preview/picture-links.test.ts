import { expect, it } from 'vitest';
import { aGraphOf, aModule } from '../model/testing/small-graph.ts';
import { foundIn, pictureOf } from './picture-links.ts';

const graph = aGraphOf(
  [
    aModule('eyes', { image: 'image2D' }, { boxes: 'object2DList', faint: 'object2DList' }),
    aModule('hands', { image: 'image2D' }, { points: 'object2DList', score: 'double' }),
    aModule('edges', { image: 'image2D' }, { drawn: 'image2D' }),
    aModule('blind', { things: 'object2DList' }, { best: 'object2DList' }),
  ],
  {
    'eyes.image': '/cam',
    'eyes.boxes': '/boxes',
    'eyes.faint': '/faint',
    'hands.image': '/cam',
    'hands.points': '/points',
    'edges.image': '/other',
    'edges.drawn': '/edges',
    'blind.things': '/boxes',
    'blind.best': '/best',
  },
);

it('knows what modules find in the pictures of a topic: the first output of each', () => {
  expect(foundIn(graph, '/cam')).toEqual(['/boxes', '/points']);
  expect(foundIn(graph, '/other')).toEqual([]);
});

it('knows in which pictures things were found, and says nothing where no module tells', () => {
  expect(pictureOf(graph, '/points')).toBe('/cam');
  expect(pictureOf(graph, '/faint')).toBe('/cam');
  expect(pictureOf(graph, '/best')).toBeUndefined();
  expect(pictureOf(graph, '/elsewhere')).toBeUndefined();
});
