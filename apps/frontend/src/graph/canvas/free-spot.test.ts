import { describe, expect, it } from 'vitest';
import type { GraphNode } from '../model/graph.ts';
import { frameNode, topicNode } from '../model/make-node.ts';
import { freeSpot } from './free-spot.ts';

const nodes = new Map<string, GraphNode>([
  ['topic:/a', topicNode('/a')],
  ['frame:1', frameNode('frame:1', 'Frame')],
]);
const stage = {
  positions: new Map([
    ['topic:/a', { x: 0, y: 0 }],
    ['frame:1', { x: -50, y: -50 }],
  ]),
  sizes: new Map([
    ['topic:/a', { width: 174, height: 76 }],
    ['frame:1', { width: 900, height: 900 }],
  ]),
};

describe('freeSpot', () => {
  it('is the place itself, on the grid, where nothing is', () => {
    expect(freeSpot(stage, { nodes }, { x: 303, y: 4 })).toEqual({ x: 300, y: 0 });
  });

  it('is below what is in the way; frames are not', () => {
    expect(freeSpot(stage, { nodes }, { x: 10, y: 20 })).toEqual({ x: 10, y: 100 });
  });
});
