import { describe, expect, it } from 'vitest';
import { stepPosition } from './step-position.ts';

describe('stepPosition()', () => {
  it('moves by a hundredth, with Shift by a tenth', () => {
    expect(stepPosition({ x: 0.5, y: 0.5 }, 'ArrowRight', false)).toEqual({ x: 0.51, y: 0.5 });
    expect(stepPosition({ x: 0.5, y: 0.5 }, 'ArrowUp', true)).toEqual({ x: 0.5, y: 0.4 });
  });

  it('stays on the pad', () => {
    expect(stepPosition({ x: 0, y: 1 }, 'ArrowLeft', true)).toEqual({ x: 0, y: 1 });
    expect(stepPosition({ x: 0, y: 0.995 }, 'ArrowDown', false)).toEqual({ x: 0, y: 1 });
  });

  it('leaves other keys alone', () => {
    expect(stepPosition({ x: 0, y: 0 }, 'Tab', false)).toBeUndefined();
  });
});
