import { describe, expect, it } from 'vitest';

import { DROP_S, dropHeight, FALL_S, touchesDown } from './standing-pieces.ts';

describe('drop of a piece that joins', () => {
  it('falls, bounces once and stands', () => {
    expect(dropHeight(FALL_S)).toBeCloseTo(0, 6);
    expect(dropHeight((FALL_S + DROP_S) / 2)).toBeGreaterThan(0.5);
    expect(dropHeight(DROP_S)).toBeCloseTo(0, 6);
    expect(dropHeight(60)).toBe(0);
  });

  it('touches down twice', () => {
    const touches = Array.from({ length: 120 }, (_, frame) =>
      touchesDown(frame / 60, (frame + 1) / 60),
    );
    expect(touches.filter(Boolean)).toHaveLength(2);
  });
});
