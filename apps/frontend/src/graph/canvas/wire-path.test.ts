import { describe, expect, it } from 'vitest';
import { curvesOf, wirePath } from './wire-path.ts';

describe('wirePath', () => {
  it('curves forward, with its middle between the ends', () => {
    const { d, middle } = wirePath({ x: 0, y: 0 }, { x: 200, y: 100 });
    expect(d).toBe('M0 0C100 0 100 100 200 100');
    expect(middle).toEqual({ x: 100, y: 50 });
  });

  it('goes back in round steps, beside both nodes', () => {
    const { d, middle } = wirePath({ x: 200, y: 0 }, { x: 0, y: 200 });
    expect(d).toMatch(/^M200 0L.*L0 200$/);
    expect(d.match(/Q/g)).toHaveLength(4);
    expect(middle).toEqual({ x: 100, y: 100 });
  });

  it('keeps clear of nodes of the same height when it goes back', () => {
    const { middle } = wirePath({ x: 200, y: 50 }, { x: 0, y: 40 });
    expect(middle.y).toBeGreaterThan(50);
  });

  it('goes through the points it is led through, and has its chip beside them', () => {
    const points = [{ x: 100, y: 80 }];
    const { d, middle } = wirePath({ x: 0, y: 0 }, { x: 300, y: 0 }, points);
    expect(d).toMatch(/^M0 0C.* 100 80C.* 300 0$/);
    expect(middle.x).toBeGreaterThan(120);
  });

  it('has no corners at points, also back and forth', () => {
    const points = [
      { x: 100, y: 80 },
      { x: -50, y: 90 },
    ];
    const [into, out] = curvesOf({ x: 0, y: 0 }, { x: 200, y: 0 }, points);
    const before = Math.atan2(into!.to.y - into!.b.y, into!.to.x - into!.b.x);
    const after = Math.atan2(out!.a.y - out!.from.y, out!.a.x - out!.from.x);
    expect(before).toBeCloseTo(after);
  });

  it('leaves and enters sockets flat', () => {
    const curves = curvesOf({ x: 0, y: 0 }, { x: 200, y: 50 }, [{ x: 100, y: 80 }]);
    expect(curves[0]!.a.y).toBe(0);
    expect(curves.at(-1)!.b.y).toBe(50);
  });
});
