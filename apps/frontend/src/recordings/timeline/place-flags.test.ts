import { expect, it } from 'vitest';
import { placeFlags } from './place-flags.ts';

it('places flags at their moments, and side by side where they would lie on each other', () => {
  expect(placeFlags([0, 50, 50, 55, 90], 10, 100)).toEqual([0, 50, 60, 70, 90]);
});

it('keeps flags at the right edge whole, and their order', () => {
  expect(placeFlags([95, 98, 100], 10, 100)).toEqual([70, 80, 90]);
});

it('lets flags lie on each other when there is no room', () => {
  expect(placeFlags([1, 2, 3], 10, 20)).toEqual([1, 2, 3]);
});
