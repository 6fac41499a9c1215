import { expect, it } from 'vitest';
import { withToggled } from './favourite-modules.ts';

it('a module is marked as favourite and unmarked, and there is an end to them', () => {
  expect(withToggled(['a'], 'b')).toEqual(['a', 'b']);
  expect(withToggled(['a', 'b'], 'a')).toEqual(['b']);
  const many = Array.from({ length: 100 }, (_, i) => String(i));
  expect(withToggled(many, 'new')).toEqual([...many.slice(1), 'new']);
});
