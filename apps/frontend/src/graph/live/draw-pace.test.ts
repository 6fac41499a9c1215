import { expect, it } from 'vitest';
import { DrawPace } from './draw-pace.ts';

const FRAME_MS = 1000 / 60;

function drawnIn(pace: DrawPace, fromMs: number, isMoving: boolean): number {
  const frames = Array.from({ length: 60 }, (_, frame) => fromMs + frame * FRAME_MS);
  return frames.filter((nowMs) => pace.take(nowMs, isMoving)).length;
}

it('draws values some times a second while the canvas rests, once while it is moved', () => {
  const pace = new DrawPace();
  const resting = drawnIn(pace, 0, false);
  expect(resting).toBeGreaterThanOrEqual(5);
  expect(resting).toBeLessThanOrEqual(6);
  expect(drawnIn(pace, 1000, true)).toBe(1);
  expect(drawnIn(pace, 2000, false)).toBeGreaterThanOrEqual(5);
});
