import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { test } from 'node:test';

import { inRoot } from './repository.mjs';

/** The folder of a package, as another one sees it. @param {string} from @param {string} name */
function folderOf(from, name) {
  return dirname(createRequire(join(from, 'package.json')).resolve(`${name}/package.json`));
}

test('the browser of the tests keeps disabled what Playwright disables', () => {
  const playwright = folderOf(folderOf(inRoot('e2e'), '@playwright/test'), 'playwright');
  const bundle = join(folderOf(playwright, 'playwright-core'), 'lib', 'coreBundle.js');
  const [, list] = /\bdisabledFeatures = \[(.+?)\]/s.exec(readFileSync(bundle, 'utf8')) ?? [];
  const names = [...(list ?? '').matchAll(/^\s*"(\w+)"/gm)].map(([, name]) => name);
  assert.ok(names.length > 5, 'the list was not found in this version of Playwright');
  const flags = readFileSync(inRoot('e2e/fixtures/chromium.ts'), 'utf8');
  assert.deepEqual(
    names.filter((name) => !flags.includes(`'${name}'`)),
    [],
  );
});
