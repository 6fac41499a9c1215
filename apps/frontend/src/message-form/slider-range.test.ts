import { expect, it } from 'vitest';
import { isSizeMember } from './slider-range.ts';

it.each([
  ['image2D.width', true],
  ['image2D.height', true],
  ['image2DList.elements[3].width', true],
  ['object2D.size.x', false],
  ['double', false],
])('%s is the size of a picture: %s', (path, isSize) => {
  expect(isSizeMember(path)).toBe(isSize);
});
