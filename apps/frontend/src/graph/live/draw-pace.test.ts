import { describe, expect, it } from 'vitest';
import { DrawPace } from './draw-pace.ts';

const NAMES = Array.from({ length: 100 }, (_, index) => `/topic/${index}`);
const FRAME_MS = 1000 / 60;

describe('values on a canvas', () => {
  it('are drawn all together, some times a second, while it rests', () => {
    const pace = new DrawPace();
    const drawn = Array.from({ length: 60 }, (_, frame) =>
      pace.take(NAMES, frame * FRAME_MS, false),
    ).filter(({ length }) => length > 0);
    expect(drawn.length).toBeGreaterThanOrEqual(5);
    expect(drawn.length).toBeLessThanOrEqual(6);
    for (const names of drawn) expect(names).toEqual(NAMES);
  });

  it('are drawn a few in each frame while it is moved, all of them in half a second', () => {
    const pace = new DrawPace();
    const seen = new Set<string>();
    for (let frame = 0; frame < 30; frame++) {
      const names = pace.take(NAMES, frame * FRAME_MS, true);
      expect(names.length).toBeLessThanOrEqual(4);
      for (const name of names) seen.add(name);
    }
    expect(seen).toEqual(new Set(NAMES));
  });

  it('have their turn also when there are fewer than before', () => {
    const pace = new DrawPace();
    for (let frame = 0; frame < 20; frame++) pace.take(NAMES, frame * FRAME_MS, true);
    expect(pace.take(['/a'], 400, true)).toEqual(['/a']);
    expect(pace.take([], 420, true)).toEqual([]);
  });
});
