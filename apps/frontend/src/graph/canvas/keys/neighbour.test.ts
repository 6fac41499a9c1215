import { describe, expect, it } from 'vitest';
import type { Box } from '../../model/selection/arrange.ts';
import { firstIn, neighbour } from './neighbour.ts';

const at = (id: string, x: number, y: number): Box => ({ id, x, y, width: 180, height: 80 });
const boxes = [at('a', 0, 0), at('b', 300, 0), at('c', 300, 200), at('d', 700, 20)];
const go = (from: string, x: number, y: number): string | undefined =>
  neighbour(
    boxes,
    boxes.find(({ id }) => id === from)!,
    { x, y },
  )?.id;

describe('neighbour', () => {
  it('is the next node in the direction', () => {
    expect(go('a', 1, 0)).toBe('b');
    expect(go('b', 1, 0)).toBe('d');
    expect(go('b', 0, 1)).toBe('c');
    expect(go('c', 0, -1)).toBe('b');
    expect(go('d', -1, 0)).toBe('b');
  });

  it('is undefined at the edge', () => {
    expect(go('a', -1, 0)).toBeUndefined();
    expect(go('c', 0, 1)).toBeUndefined();
  });
});

describe('firstIn', () => {
  it('is the leftmost node in view, of those the topmost', () => {
    expect(firstIn(boxes, { x: -50, y: -50, width: 1000, height: 400 })?.id).toBe('a');
    expect(firstIn(boxes, { x: 250, y: -50, width: 700, height: 400 })?.id).toBe('b');
  });

  it('is the first of all where none is in view', () => {
    expect(firstIn(boxes, { x: 5000, y: 0, width: 100, height: 100 })?.id).toBe('a');
    expect(firstIn([], { x: 0, y: 0, width: 100, height: 100 })).toBeUndefined();
  });
});
