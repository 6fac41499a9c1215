import { describe, expect, it } from 'vitest';
import { nearestOn, roomiest, spotsOf } from './wire-hit.ts';

const from = { x: 0, y: 0 };
const to = { x: 400, y: 0 };

describe('places on wires', () => {
  it('finds the nearest one, also between those that are looked at', () => {
    expect(nearestOn(spotsOf(from, to, []), { x: 203, y: 12 })).toMatchObject({
      x: expect.closeTo(203),
      y: 0,
      leg: 0,
      distance: expect.closeTo(12),
    });
  });

  it('says between which points it is', () => {
    const points = [
      { x: 100, y: 100 },
      { x: 300, y: 100 },
    ];
    const spots = spotsOf(from, to, points);
    expect(nearestOn(spots, { x: 20, y: 10 })?.leg).toBe(0);
    expect(nearestOn(spots, { x: 200, y: 130 })?.leg).toBe(1);
    expect(nearestOn(spots, { x: 390, y: 10 })?.leg).toBe(2);
  });

  it('knows the steps of wires that go back', () => {
    const spots = spotsOf(to, { x: 0, y: 200 }, []);
    expect(nearestOn(spots, { x: 200, y: 105 })).toMatchObject({ y: 100, distance: 5 });
  });

  it('finds the middle of the longest leg', () => {
    expect(roomiest(from, to, [])).toEqual({ x: 200, y: 0, leg: 0 });
    expect(roomiest(from, to, [{ x: 100, y: 0 }])).toMatchObject({ leg: 1 });
    expect(roomiest(to, { x: 0, y: 200 }, [])).toEqual({ x: 200, y: 100, leg: 0 });
  });
});
