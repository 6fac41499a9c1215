import { expect, it } from 'vitest';

import { similarName } from './member-names.ts';

const NAMES = ['topic', 'double', 'string', 'stringList', 'vector2', 'vector3', 'x'];

it.each([
  ['strin', 'string'],
  ['strnig', 'string'],
  ['String', 'string'],
  ['stringlst', 'stringList'],
  ['vector4', 'vector2'],
  ['u', undefined],
  ['colour', undefined],
  ['', undefined],
])('for %j proposes %j', (misspelt, name) => {
  expect(similarName(misspelt, NAMES)).toBe(name);
});
