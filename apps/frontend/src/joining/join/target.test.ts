import { expect, it } from 'vitest';
import { safeTarget } from './target.ts';

it.each([
  ['/topics', '/topics'],
  ['/a?b=1#c', '/a?b=1#c'],
  ['//evil.example', '/'],
  ['/\\evil.example', '/'],
  ['https://evil.example', '/'],
  ['javascript:alert(1)', '/'],
  ['', '/'],
  [undefined, '/'],
  [['/a'], '/'],
])('%j leads to %s [AC-10]', (path, target) => {
  expect(safeTarget(path)).toBe(target);
});
