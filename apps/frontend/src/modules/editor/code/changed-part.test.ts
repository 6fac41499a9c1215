import { expect, it } from 'vitest';
import { changedPart } from './changed-part.ts';

it.each([
  ['abcd', 'abXcd', { from: 2, to: 2, text: 'X' }],
  ['abcd', 'ad', { from: 1, to: 3, text: '' }],
  ['aa', 'aaa', { from: 2, to: 2, text: 'a' }],
  ['aaa', 'aa', { from: 2, to: 3, text: '' }],
  ['', 'a', { from: 0, to: 0, text: 'a' }],
])('%s to %s', (before, after, part) => {
  expect(changedPart(before, after)).toEqual(part);
});
