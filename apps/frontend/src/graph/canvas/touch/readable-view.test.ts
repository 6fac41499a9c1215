import { expect, it } from 'vitest';
import { readableView } from './readable-view.ts';

const BOX = { x: 100, y: 50, width: 900, height: 400 };

it('begins where the graph begins when all of it would be too small on a phone', () => {
  const view = readableView({ x: 0, y: 0, k: 0.3 }, BOX, { width: 390, height: 700 });
  expect(view?.k).toBe(0.7);
  expect(100 * 0.7 + view!.x).toBeCloseTo(24);
});

it('leaves what can be read, and wide screens, as they are', () => {
  expect(readableView({ x: 0, y: 0, k: 0.8 }, BOX, { width: 390, height: 700 })).toBeUndefined();
  expect(readableView({ x: 0, y: 0, k: 0.3 }, BOX, { width: 1024, height: 700 })).toBeUndefined();
  expect(
    readableView({ x: 0, y: 0, k: 0.3 }, undefined, { width: 390, height: 700 }),
  ).toBeUndefined();
});

it('shows all of a small graph, whose output would else be cut off', () => {
  expect(readableView({ x: 0, y: 0, k: 0.45 }, BOX, { width: 390, height: 700 })).toBeUndefined();
});
