import { describe, expect, it } from 'vitest';
import type { GraphNode, Point } from '../model/graph.ts';
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

  it('is right of what is in the way where that is nearer', () => {
    expect(freeSpot(stage, { nodes }, { x: 160, y: 0 })).toEqual({ x: 200, y: 0 });
  });

  it('is in view while there is room in it', () => {
    const area = { x: -10, y: -10, width: 600, height: 130 };
    expect(freeSpot(stage, { nodes }, { x: 10, y: 20 }, { area })).toEqual({ x: 200, y: 20 });
    expect(freeSpot(stage, { nodes }, { x: 900, y: 900 }, { area })).toEqual({ x: 410, y: 40 });
  });

  it('gives each of many nodes a place of its own in view', () => {
    const area = { x: 0, y: 0, width: 1000, height: 600 };
    const size = { width: 184, height: 110 };
    const filled = { positions: new Map<string, Point>(), sizes: new Map() };
    for (let count = 0; count < 12; count += 1) {
      const { x, y } = freeSpot(filled, { nodes }, { x: 400, y: 200 }, { area, size });
      expect(x).toBeGreaterThanOrEqual(0);
      expect(y).toBeGreaterThanOrEqual(0);
      expect(x + size.width).toBeLessThanOrEqual(1000);
      expect(y + size.height).toBeLessThanOrEqual(600);
      for (const other of filled.positions.values()) {
        const isApart = Math.abs(other.x - x) >= size.width || Math.abs(other.y - y) >= size.height;
        expect(isApart).toBe(true);
      }
      filled.positions.set(`node ${count}`, { x, y });
      filled.sizes.set(`node ${count}`, size);
    }
  });
});
