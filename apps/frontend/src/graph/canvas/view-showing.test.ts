import { expect, it } from 'vitest';
import { viewShowing } from './view-showing.ts';

const viewport = { width: 800, height: 600 };
const box = { x: 100, y: 100, width: 180, height: 80 };

it('leaves what is seen where it is', () => {
  expect(viewShowing({ x: 0, y: 0, k: 1 }, viewport, box)).toBeUndefined();
});

it('moves as little as is needed', () => {
  expect(viewShowing({ x: 560, y: 0, k: 1 }, viewport, box)).toEqual({ x: 496, y: 0, k: 1 });
  expect(viewShowing({ x: -200, y: 0, k: 1 }, viewport, box)).toEqual({ x: -76, y: 0, k: 1 });
  expect(viewShowing({ x: 0, y: 460, k: 1 }, viewport, box)).toEqual({ x: 0, y: 348, k: 1 });
});

it('shows where something begins that is larger than the viewport', () => {
  const wide = { ...box, width: 2000 };
  expect(viewShowing({ x: 0, y: 0, k: 1 }, viewport, wide)).toEqual({ x: -76, y: 0, k: 1 });
});
