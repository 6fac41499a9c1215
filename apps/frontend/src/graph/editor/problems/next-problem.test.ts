import { expect, it } from 'vitest';
import { nextProblem } from './next-problem.ts';

const rows = [{ node: 'a' }, { node: undefined }, { node: 'a' }, { node: 'b' }];

it('the next problem is on another node, and after the last comes the first', () => {
  expect(nextProblem(rows, undefined)).toBe('a');
  expect(nextProblem(rows, 'a')).toBe('b');
  expect(nextProblem(rows, 'b')).toBe('a');
  expect(nextProblem(rows, 'without a problem')).toBe('a');
});

it('problems of the session as a whole have no node', () => {
  expect(nextProblem([{ node: undefined }], 'a')).toBeUndefined();
});
