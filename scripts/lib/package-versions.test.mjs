import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';

import { readLock } from './lockfile.mjs';
import { inRoot, readJson } from './repository.mjs';

const { version } = readJson(inRoot('package.json'));

test('all packages of the workspace have the same version', () => {
  const folders = [...readLock().importers.keys()];
  assert.ok(folders.includes('apps/master'));
  const others = folders
    .map((folder) => ({ folder, version: readJson(inRoot(folder, 'package.json')).version }))
    .filter((one) => one.version !== version);
  assert.deepEqual(others, []);
});

test('the changelog has the version', () => {
  const headings = readFileSync(inRoot('CHANGELOG.md'), 'utf8').match(/^## .+$/gm);
  assert.equal(headings[0], '## Unreleased');
  assert.equal(headings[1], `## ${version}`);
});
