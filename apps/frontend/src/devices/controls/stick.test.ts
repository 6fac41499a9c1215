import { describe, expect, it } from 'vitest';
import { stickOfKeys, withDeadZone, withinCircle } from './stick.ts';

describe('a stick', () => {
  it('reaches 1 in every direction and no further', () => {
    expect(withinCircle({ x: 0, y: -2 })).toEqual({ x: 0, y: -1 });
    const { x, y } = withinCircle({ x: 1, y: 1 });
    expect(Math.hypot(x, y)).toBeCloseTo(1);
    expect(withinCircle({ x: 0.2, y: 0.3 })).toEqual({ x: 0.2, y: 0.3 });
  });

  it('says nothing in its dead zone, begins at 0 beyond it, and reaches 1', () => {
    expect(withDeadZone({ x: 0.05, y: -0.05 }, 0.1)).toEqual({ x: 0, y: 0 });
    expect(withDeadZone({ x: 0.1001, y: 0 }, 0.1).x).toBeCloseTo(0, 3);
    expect(withDeadZone({ x: 0, y: -1 }, 0.1)).toEqual({ x: 0, y: -1 });
  });

  it('is pushed by keys; opposite ones take each other back', () => {
    expect(stickOfKeys(['ArrowUp'])).toEqual({ x: 0, y: 1 });
    expect(stickOfKeys(['KeyA', 'KeyD', 'KeyS'])).toEqual({ x: 0, y: -1 });
    expect(stickOfKeys(['ArrowUp', 'KeyW'])).toEqual({ x: 0, y: 1 });
    expect(stickOfKeys(['KeyW', 'KeyD']).x).toBeCloseTo(Math.SQRT1_2);
    expect(stickOfKeys([])).toEqual({ x: 0, y: 0 });
  });
});
