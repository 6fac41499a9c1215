import { expect, it } from 'vitest';
import { coveredView } from './covered-view.ts';

const VIEWPORT = { width: 1000, height: 800 };
const VIEW = { x: 0, y: 0, k: 1 };
const box = (x: number, y: number) => ({ x, y, width: 200, height: 100 });

it('shows all of a graph that was visible as a whole, above what covers it', () => {
  const boxes = [box(100, 100), box(600, 600)];
  const { y, k } = coveredView(VIEW, boxes, VIEWPORT, 400);
  expect(k).toBeLessThan(1);
  expect(100 * k + y).toBeGreaterThan(0);
  expect(700 * k + y).toBeLessThan(400);
});

it('stays where nothing is covered', () => {
  expect(coveredView(VIEW, [box(100, 100)], VIEWPORT, 400)).toBe(VIEW);
});

it('keeps what was in the middle of a larger graph in the middle', () => {
  const boxes = [box(100, 100), box(2000, 600)];
  expect(coveredView(VIEW, boxes, VIEWPORT, 400)).toEqual({ x: 0, y: -200, k: 1 });
});
