import { expect, it } from 'vitest';

import { isFailure } from './master-process.ts';

it.each([
  ['{"level":"error","msg":"x"}', true],
  ['{"level":"warn","msg":"Error"}', false],
  ['{"level":"err', true],
  ['    at run (file:///main.js:1:2)', true],
  ['TypeError: x is not a function', true],
  ['(node:12) Warning: x', true],
  ['Listening on http://localhost:8080', false],
])('whether %s reports a defect: %s', (line, expected) => {
  expect(isFailure(line)).toBe(expected);
});
