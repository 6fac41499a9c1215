import { expect, it } from 'vitest';
import { aStudy } from './testing/a-study.ts';
import { withStudy } from './useStudies.ts';

it('a saved study is in the list at once, in place of what it was', () => {
  const list = [aStudy({ id: 'a', name: 'A' }), aStudy({ id: 'c', name: 'C' })];
  const names = (id: string, name: string) =>
    withStudy(list, aStudy({ id, name })).map((study) => study.name);
  expect(names('b', 'B')).toEqual(['A', 'B', 'C']);
  expect(names('a', 'D')).toEqual(['C', 'D']);
});
