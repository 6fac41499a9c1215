import { describe, expect, it } from 'vitest';
import { wirePath } from './wire-path.ts';

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

  it('goes through the points it is led through', () => {
    const { d, middle } = wirePath({ x: 0, y: 0 }, { x: 200, y: 0 }, [{ x: 100, y: 80 }]);
    expect(d).toContain('100 80');
    expect(middle).toEqual({ x: 100, y: 80 });
  });
});
