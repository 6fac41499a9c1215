import assert from 'node:assert/strict';
import { test } from 'node:test';

import { engineProblems } from './node-engines.mjs';

const packages = [
  { name: 'fine', version: '1.0.0', nodeRange: '^20.19.0 || >=22' },
  { name: 'silent', version: '1.0.0', nodeRange: '' },
  { name: 'late', version: '3.0.0', nodeRange: '>= 22.x' },
];

test('a package that does not take the lowest version of Node is named', () => {
  const problems = engineProblems(packages, '20.19.0', {});
  assert.equal(problems.length, 1);
  assert.match(problems[0], /^late@3\.0\.0 asks for Node >= 22\.x, and not 20\.19\.0/);
  assert.deepEqual(engineProblems(packages, '22.0.0', {}), []);
});

test('a range that cannot be read admits nothing', () => {
  const strange = [{ name: 'strange', version: '1.0.0', nodeRange: 'any' }];
  assert.equal(engineProblems(strange, '20.19.0', {}).length, 1);
});

test('an exception is for one range, and fails when it is not needed', () => {
  const exceptions = { late: { node: '>= 22.x', reason: '' } };
  assert.deepEqual(engineProblems(packages, '20.19.0', exceptions), []);
  const later = [{ name: 'late', version: '4.0.0', nodeRange: '>=24' }];
  assert.equal(engineProblems(later, '20.19.0', exceptions).length, 2);
  assert.match(engineProblems([], '20.19.0', exceptions)[0], /late.*remove it/);
});
