import { FakeClock } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import { FrameSlices } from './frame-slices.ts';

function setup() {
  const turns: (() => void)[] = [];
  const clock = { atEndOfTurn: (fn: () => void) => void turns.push(fn) };
  const slices = new FrameSlices(clock);
  const read: string[] = [];
  const framesOf = (name: string, count: number) => ({
    readSlice: () => {
      read.push(name);
      return --count === 0;
    },
  });
  /** @returns what was read in this turn */
  const endTurn = (): string[] => {
    for (const fn of turns.splice(0)) fn();
    return read.splice(0);
  };
  return { slices, framesOf, endTurn };
}

describe('slices of frames', () => {
  it('are read one in each turn, of one client after the other [TD-71]', () => {
    const { slices, framesOf, endTurn } = setup();
    slices.add(framesOf('a', 2));
    slices.add(framesOf('b', 3));
    expect(Array.from({ length: 6 }, endTurn)).toEqual([['a'], ['b'], ['a'], ['b'], ['b'], []]);
  });

  it('are not read of a client that was removed', () => {
    const { slices, framesOf, endTurn } = setup();
    const frames = framesOf('a', 2);
    slices.add(frames);
    endTurn();
    slices.remove(frames);
    slices.add(framesOf('b', 2));
    expect(Array.from({ length: 4 }, endTurn)).toEqual([['b'], ['b'], [], []]);
  });

  it('need no turn while there are none', () => {
    const clock = new FakeClock();
    const slices = new FrameSlices(clock);
    slices.add({ readSlice: () => true });
    clock.endTurnSync();
    expect(clock.endOfTurnCount).toBe(0);
  });
});
