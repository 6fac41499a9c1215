import { describe, expect, it } from 'vitest';
import { snapMove } from './guides.ts';

const box = { id: 'a', x: 0, y: 0, width: 100, height: 50 };
const other = { id: 'b', x: 203, y: 300, width: 100, height: 50 };
const options = { others: [other], reach: 6, grid: 10, anchor: box };

describe('snapMove', () => {
  it('lines up with another box, and shows from where to where', () => {
    const { by, lines } = snapMove(box, { x: 199, y: 22 }, options);
    expect(by).toEqual({ x: 203, y: 20 });
    expect(lines).toEqual([{ axis: 'x', at: 203, from: 20, to: 350 }]);
  });

  it('goes to the grid where nothing is near', () => {
    expect(snapMove(box, { x: 43, y: 88 }, options)).toEqual({ by: { x: 40, y: 90 }, lines: [] });
  });

  it('puts the anchor on the grid, not the box around all that moves', () => {
    const { by } = snapMove(box, { x: 43, y: 88 }, { ...options, anchor: { x: 7, y: 3 } });
    expect(by).toEqual({ x: 43, y: 87 });
  });

  it('lines up middles of odd sizes on whole pixels', () => {
    const odd = { id: 'c', x: 200, y: 300, width: 55, height: 10 };
    const { by, lines } = snapMove(box, { x: 178, y: 100 }, { ...options, others: [odd] });
    expect(Number.isInteger(by.x)).toBe(true);
    expect(lines).toEqual([{ axis: 'x', at: 227.5, from: 100, to: 310 }]);
  });

  it('lets others alone without a reach', () => {
    const { by, lines } = snapMove(box, { x: 199, y: 22 }, { ...options, reach: 0 });
    expect(by).toEqual({ x: 200, y: 20 });
    expect(lines).toEqual([]);
  });
});
