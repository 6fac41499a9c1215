import assert from 'node:assert/strict';
import { test } from 'node:test';

import { affectedPackages, folderOf } from './changes.mjs';

test('a file belongs to the folder of its package', () => {
  assert.equal(folderOf('packages/proto/src/index.ts'), 'packages/proto');
  assert.equal(folderOf('e2e/tests/start/npm-start.spec.ts'), 'e2e');
  assert.equal(folderOf('docs/glossary.md'), undefined);
});

test('a file affects its package and those that depend on it', async () => {
  const affected = await affectedPackages(['packages/words/src/words.ts', 'README.md']);
  for (const name of ['@ubii/words', '@ubii/master', '@ubii/frontend']) {
    assert.ok(affected.has(name), name);
  }
  assert.ok(!affected.has('@ubii/patterns'));
  assert.equal((await affectedPackages(['README.md'])).size, 0);
});

test('a file of the whole workspace affects every package', async () => {
  const affected = await affectedPackages(['pnpm-lock.yaml']);
  assert.ok(affected.has('@ubii/patterns') && affected.has('@ubii/robustness'));
});
