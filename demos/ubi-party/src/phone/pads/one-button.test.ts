import { expect, test } from 'vitest';
import { ONE_BUTTON_AT_REST, pressed, sweepOf, swept } from './one-button.ts';

const after = (ms: number) => swept(ONE_BUTTON_AT_REST, ms);

test('pointer of a wheel sweeps right, then left, and waits in the middle', () => {
  expect(sweepOf(after(900), 'wheel').x).toBe(1);
  expect(sweepOf(after(2700), 'wheel').x).toBe(-1);
  expect(sweepOf(after(1750), 'wheel').x).toBe(0);
  expect(sweepOf(after(3600), 'wheel').x).toBe(0);
});

test('pointer of a stick goes round, away from the player first', () => {
  expect(sweepOf(after(0), 'stick')).toEqual({ x: 0, y: 1 });
  expect(sweepOf(after(900), 'stick').x).toBeCloseTo(1);
  expect(sweepOf(after(1800), 'stick').y).toBeCloseTo(-1);
});

test('press takes the direction and keeps it while the pointer goes on', () => {
  const down = pressed(after(900), true, 'wheel');
  expect(down.taken).toEqual({ x: 1, y: 0 });
  const later = swept(pressed(down, false, 'wheel'), 1800);
  expect(later.taken).toEqual({ x: 1, y: 0 });
  expect(sweepOf(later, 'wheel').x).toBe(-1);
});

test('pointer waits while the button is held, so that a dash flies where it was aimed', () => {
  const down = pressed(after(900), true, 'stick');
  expect(swept(down, 500)).toEqual(down);
});

test('nothing is steered before the first press, nor in a game without steering', () => {
  expect(after(900).taken).toEqual({ x: 0, y: 0 });
  expect(pressed(after(900), true, 'none').taken).toEqual({ x: 0, y: 0 });
});
