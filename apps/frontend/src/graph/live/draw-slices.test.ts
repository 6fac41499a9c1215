import { describe, expect, it } from 'vitest';
import { DrawSlices } from './draw-slices.ts';

const FRAME_MS = 1000 / 60;
const NODES = Array.from({ length: 200 }, (_, index) => index);

/** Returns the slices of consecutive frames; `frameMs` gives a frame's duration by the size of its slice. */
function drawn(
  slices: DrawSlices<number>,
  frames: number,
  frameMs: (count: number) => number,
  isMoving = false,
  fromMs = 0,
): (readonly number[])[] {
  return Array.from({ length: frames }, (_, frame) => {
    const slice = slices.next(fromMs + frame * FRAME_MS, isMoving);
    if (slice.length > 0) slices.took(frameMs(slice.length));
    return slice;
  });
}
const most = (slices: readonly (readonly number[])[]): number =>
  Math.max(...slices.map(({ length }) => length));

describe('values are drawn in slices', () => {
  it('of which no frame gets more than it has room for', () => {
    const slices = new DrawSlices(
      () => NODES,
      () => true,
    );
    const costly = (count: number): number => 2 * count;
    const first = drawn(slices, 60, costly);
    expect(most(first)).toBeGreaterThan(1);
    // The slice grows by one above the limit before it shrinks.
    expect(most(first)).toBeLessThanOrEqual(6);
  });

  it('one after the other, all of them, in a round', () => {
    const slices = new DrawSlices(
      () => NODES,
      () => true,
    );
    const round = drawn(slices, 30, () => 1).flat();
    expect(round.slice(0, NODES.length)).toEqual(NODES);
  });

  it('some times a second at rest, and seldom while the canvas is moved', () => {
    const few = new DrawSlices(
      () => [1, 2],
      () => true,
    );
    const count = (isMoving: boolean, fromMs: number): number =>
      drawn(few, 60, () => 1, isMoving, fromMs).flat().length / 2;
    const resting = count(false, 0);
    expect(resting).toBeGreaterThanOrEqual(5);
    expect(resting).toBeLessThanOrEqual(6);
    const moving = count(true, 1000);
    expect(moving).toBeGreaterThanOrEqual(1);
    expect(moving).toBeLessThanOrEqual(2);
  });

  it('and go on in frames that are too long without them', () => {
    const slices = new DrawSlices(
      () => NODES,
      () => true,
    );
    const slow = drawn(slices, NODES.length, () => 100);
    expect(slow.flat()).toEqual(NODES);
  });

  it('several in one of some frames while the canvas is moved, and the others draw none', () => {
    const slices = new DrawSlices(
      () => NODES,
      () => true,
    );
    const sizes = drawn(slices, 12, () => 100, true).map(({ length }) => length);
    expect(sizes).toEqual([0, 0, 0, 0, 0, 8, 0, 0, 0, 0, 0, 8]);
  });

  it('what is out of view less often, and not at all while the canvas is moved', () => {
    const slices = new DrawSlices(
      () => NODES.slice(0, 8),
      (one) => one < 4,
    );
    const all = drawn(slices, 60, () => 1).flat();
    const times = (one: number): number => all.filter((other) => other === one).length;
    expect(times(0)).toBeGreaterThanOrEqual(4);
    expect(times(7)).toBe(2);
    const moved = drawn(slices, 60, () => 1, true, 10_000).flat();
    expect(new Set(moved)).toEqual(new Set([0, 1, 2, 3]));
  });
});
