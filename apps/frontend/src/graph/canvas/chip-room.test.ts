import { describe, expect, it } from 'vitest';
import type { Wire } from '../model/graph.ts';
import { chipParts, chipRoom, MAX_CHIP } from './chip-room.ts';

const wire = {
  id: 'w',
  from: { node: 'a', port: 'out' },
  to: { node: 'b', port: 'in' },
  points: [],
} as unknown as Wire;
const size = { width: 180, height: 100 };
const stageWith = (x: number, y = 0) => ({
  positions: new Map([
    ['a', { x: 0, y: 0 }],
    ['b', { x, y }],
  ]),
  sizes: new Map([
    ['a', size],
    ['b', size],
  ]),
});

describe('chipRoom', () => {
  it('leaves the sockets of both ends free', () => {
    expect(chipRoom(stageWith(280), wire, { x: 230, y: 40 })).toBe(72);
    expect(chipRoom(stageWith(200), wire, { x: 190, y: 40 })).toBe(0);
  });

  it('is wide where the nodes are far apart', () => {
    expect(chipRoom(stageWith(900), wire, { x: 540, y: 40 })).toBe(MAX_CHIP);
  });

  it('is wide above and below both nodes', () => {
    expect(chipRoom(stageWith(190, 400), wire, { x: 185, y: 250 })).toBe(MAX_CHIP);
  });
});

describe('chipParts', () => {
  it('shows more on wider chips', () => {
    expect(chipParts(61, false)).toEqual({ rate: false, age: false, beside: false });
    expect(chipParts(62, false)).toEqual({ rate: true, age: false, beside: false });
    expect(chipParts(72, false)).toEqual({ rate: true, age: true, beside: false });
    expect(chipParts(104, false)).toEqual({ rate: true, age: true, beside: true });
  });

  it('counts the mark of a problem, which would cut the rate', () => {
    expect(chipParts(72, true)).toEqual({ rate: false, age: false, beside: false });
    expect(chipParts(80, true)).toEqual({ rate: true, age: false, beside: false });
  });
});
