import assert from 'node:assert/strict';
import { test } from 'node:test';

import {
  installedLicences,
  isAllowed,
  licenceOf,
  licenceProblems,
} from './dependency-licences.mjs';
import { productionPackages, readLock } from './lockfile.mjs';

const allowed = ['MIT', 'ISC', 'Apache-2.0'];

for (const [expression, expected] of [
  ['MIT', true],
  ['GPL-3.0', false],
  ['(MIT OR GPL-3.0)', true],
  ['GPL-3.0 OR MIT', true],
  ['MIT AND ISC', true],
  ['MIT AND GPL-3.0', false],
  ['GPL-3.0 AND MIT OR ISC', true],
  ['GPL-3.0 AND (MIT OR ISC)', false],
  ['MIT WITH Some-exception', false],
  ['SEE LICENSE IN license.txt', false],
  ['(MIT', false],
  ['', false],
]) {
  test(`${expression} is ${expected ? '' : 'not '}allowed`, () => {
    assert.equal(isAllowed(expression, allowed), expected);
  });
}

test('packages are named that may not be shipped', () => {
  const exceptions = { graph: { licence: 'EPL-2.0', reason: 'unmodified' } };
  const packages = [
    { name: 'fine', version: '1.0.0', licence: 'MIT' },
    { name: 'graph', version: '1.0.0', licence: 'EPL-2.0' },
    { name: 'viral', version: '2.0.0', licence: 'AGPL-3.0' },
    { name: 'silent', version: '3.0.0', licence: undefined },
  ];
  const problems = licenceProblems(packages, { allowed, exceptions });
  assert.equal(problems.length, 2);
  assert.match(problems[0], /^viral@2\.0\.0 has the licence AGPL-3\.0/);
  assert.match(problems[1], /^silent@3\.0\.0 has the licence that is not told/);
});

test('an exception is for one licence: when the package changes it, it is looked at again', () => {
  const policy = { allowed, exceptions: { graph: { licence: 'EPL-2.0', reason: '' } } };
  assert.equal(
    licenceProblems([{ name: 'graph', version: '2.0.0', licence: 'BUSL-1.1' }], policy).length,
    1,
  );
});

test('older manifests tell their licence otherwise', () => {
  assert.equal(licenceOf({ license: { type: 'MIT' } }), 'MIT');
  assert.equal(licenceOf({ licenses: [{ type: 'MIT' }, { type: 'ISC' }] }), 'MIT OR ISC');
  assert.equal(licenceOf({}), undefined);
});

test('every package that people get tells its licence, but those for other systems', () => {
  const licence = installedLicences();
  const lock = readLock();
  for (const key of productionPackages(lock)) {
    if (!lock.packages.get(key).isForSomeSystems) assert.ok(licence(key) !== undefined, key);
  }
});
