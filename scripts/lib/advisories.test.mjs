import assert from 'node:assert/strict';
import { test } from 'node:test';

import {
  advisoriesFromAnswer,
  ageOfAdvisories,
  checkAdvisories,
  versionsByName,
} from './advisories.mjs';
import { checkDependencies } from './dependencies.mjs';
import { readLock } from './lockfile.mjs';

const leak = {
  id: 'GHSA-aaaa-bbbb-cccc',
  title: 'It leaks',
  severity: 'high',
  vulnerable_versions: '>=1.0.0 <1.2.3 || >=2.0.0 <2.0.1',
  url: 'https://github.com/advisories/GHSA-aaaa-bbbb-cccc',
};
const packages = [
  { name: 'pipe', version: '1.2.2' },
  { name: 'pipe', version: '1.2.3' },
  { name: 'tap', version: '5.0.0' },
];
const file = (advisory = leak, asked = versionsByName(packages)) => ({
  updated: '2026-01-01',
  source: 'a test',
  asked,
  advisories: { pipe: [advisory] },
});

test('a locked version that is vulnerable fails, others do not', () => {
  const { problems, notes } = checkAdvisories(packages, file(), {});
  assert.equal(problems.length, 1);
  assert.match(problems[0], /^pipe@1\.2\.2: It leaks \(high, https:/);
  assert.deepEqual(notes, []);
});

test('a package that is locked here fails with an advisory that has its version', () => {
  const locked = [...readLock().packages.values()];
  const { version } = locked.find(({ name }) => name === 'fastify');
  const known = { ...file(), advisories: { fastify: [{ ...leak, vulnerable_versions: version }] } };
  const { problems } = checkAdvisories(locked, known, {});
  assert.deepEqual(
    problems.map((problem) => problem.split(':')[0]),
    [`fastify@${version}`],
  );
});

test('what is critical fails, what is less than high is told', () => {
  const severities = ['critical', 'moderate', 'low'];
  const counts = severities.map((severity) => {
    const { problems, notes } = checkAdvisories(packages, file({ ...leak, severity }), {});
    return [problems.length, notes.length];
  });
  assert.deepEqual(counts, [
    [1, 0],
    [0, 1],
    [0, 1],
  ]);
});

test('a version before its release counts as what it comes before', () => {
  const early = [{ name: 'pipe', version: '1.2.0-beta.1' }];
  assert.equal(checkAdvisories(early, file(), {}).problems.length, 1);
});

test('an exception lets it pass and says why; one that is not needed fails', () => {
  const exceptions = { [leak.id]: { package: 'pipe', reason: 'no water in it' } };
  const { problems, notes } = checkAdvisories(packages, file(), exceptions);
  assert.deepEqual(problems, []);
  assert.match(notes[0], /no water in it/);
  const other = { [leak.id]: { package: 'tap', reason: '' } };
  assert.equal(checkAdvisories(packages, file(), other).problems.length, 2);
});

test('versions that were not asked for are told', () => {
  const { notes } = checkAdvisories(packages, file(leak, { pipe: ['1.2.2', '1.2.3'] }), {});
  assert.match(notes[0], /^1 locked versions were not asked for \(tap@5\.0\.0\)/);
});

test('a range that is none is an error, and not taken for safe', () => {
  const broken = { ...leak, vulnerable_versions: 'before 2' };
  assert.throws(() => checkAdvisories(packages, file(broken), {}), /before 2/);
});

test('the age is told, and an old file asks for a newer one', () => {
  const after = (days) => Date.parse('2026-01-01') + days * 86_400_000;
  assert.equal(
    ageOfAdvisories(file(), after(90)),
    'advisories of 2026-01-01 (90 days ago; a test)',
  );
  assert.match(ageOfAdvisories(file(), after(91)), /91 days ago.*They are old/);
});

test('the registry is asked by name, and its answer kept by the names of advisories', () => {
  assert.deepEqual(versionsByName(packages), { pipe: ['1.2.2', '1.2.3'], tap: ['5.0.0'] });
  const answer = { pipe: [{ ...leak, id: 1234567, cwe: [], cvss: {} }] };
  assert.deepEqual(advisoriesFromAnswer(answer), { pipe: [leak] });
});

test('the age fails nothing: the gate is the same on every day', () => {
  const { problems } = checkDependencies(Date.parse('2099-01-01'));
  assert.deepEqual(problems, checkDependencies(0).problems);
});
