import assert from 'node:assert/strict';
import { mkdtempSync, mkdirSync, rmSync, utimesSync, writeFileSync } from 'node:fs';
import { join, relative } from 'node:path';
import { test } from 'node:test';

import { fingerprint } from './fingerprint.mjs';
import { cacheFolder, root } from './repository.mjs';

function folder(t) {
  mkdirSync(cacheFolder, { recursive: true });
  const path = mkdtempSync(join(cacheFolder, 'fingerprint-'));
  t.after(() => rmSync(path, { recursive: true }));
  return { path, of: () => fingerprint([relative(root, path)]) };
}

test('a fingerprint follows names and contents, not dates', (t) => {
  const { path, of } = folder(t);
  writeFileSync(join(path, 'a.ts'), 'one');
  const before = of();
  utimesSync(join(path, 'a.ts'), 1, 1);
  assert.equal(of(), before);
  writeFileSync(join(path, 'a.ts'), 'two');
  assert.notEqual(of(), before);
  writeFileSync(join(path, 'a.ts'), 'one');
  assert.equal(of(), before);
  writeFileSync(join(path, 'b.ts'), '');
  assert.notEqual(of(), before);
});

test('what does not end up in a build does not make it stale', (t) => {
  const { path, of } = folder(t);
  writeFileSync(join(path, 'a.ts'), 'one');
  const before = of();
  for (const name of ['dist', 'node_modules', '.cache', '.cache-lan-connections', 'test']) {
    mkdirSync(join(path, name));
    writeFileSync(join(path, name, 'x.ts'), name);
  }
  writeFileSync(join(path, 'a.test.ts'), '');
  writeFileSync(join(path, 'README.md'), '');
  assert.equal(of(), before);
});

test('a path that does not exist counts as nothing', () => {
  assert.equal(fingerprint(['not/there']), fingerprint([]));
});
