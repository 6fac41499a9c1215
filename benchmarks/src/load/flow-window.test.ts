import { describe, expect, it } from 'vitest';
import { FlowWindow } from './flow-window.ts';

describe('FlowWindow', () => {
  it('is as far as the slowest subscriber', () => {
    const flow = new FlowWindow(3, 4);
    expect(flow.advance(0, 4)).toBe(false);
    expect(flow.advance(0, 2)).toBe(false);
    expect(flow.advance(0, 1)).toBe(true);
    expect(flow.slowest).toBe(1);
    expect(flow.advance(1, 4)).toBe(true);
    expect(flow.slowest).toBe(2);
    expect(flow.advance(2, 4)).toBe(true);
    expect(flow.slowest).toBe(4);
  });

  it('agrees with the plain minimum over many steps', () => {
    const window = 64;
    const positions = new Array<number>(10).fill(0);
    const flow = new FlowWindow(positions.length, window);
    for (let step = 0; step < 5000; step += 1) {
      const subscriber = (step * 7 + (step >> 3)) % positions.length;
      const from = positions[subscriber]!;
      const to = Math.min(from + ((step * 13) % 5), Math.min(...positions) + window);
      if (to === from) continue;
      positions[subscriber] = to;
      flow.advance(from, to);
      expect(flow.slowest).toBe(Math.min(...positions));
    }
    expect(flow.slowest).toBeGreaterThan(window);
  });
});
