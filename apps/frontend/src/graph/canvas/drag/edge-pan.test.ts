import { describe, expect, it } from 'vitest';
import { edgeStep } from './edge-pan.ts';

describe('edgeStep', () => {
  it('moves nothing while the pointer is inside', () => {
    expect(edgeStep(500, 1000)).toBe(0);
    expect(edgeStep(40, 1000)).toBe(0);
  });

  it('shows what is beyond the edge, the faster the nearer', () => {
    expect(edgeStep(10, 1000)).toBeGreaterThan(edgeStep(20, 1000));
    expect(edgeStep(20, 1000)).toBeGreaterThan(0);
    expect(edgeStep(990, 1000)).toBeLessThan(0);
  });

  it('has a greatest speed', () => {
    expect(edgeStep(-400, 1000)).toBe(edgeStep(-10, 1000));
  });
});
