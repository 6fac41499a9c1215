import { expect, it } from 'vitest';
import { HULL } from './model-scene.ts';

it('the hull is closed at both ends', () => {
  expect([HULL.at(0)?.x, HULL.at(-1)?.x]).toEqual([0, 0]);
});
