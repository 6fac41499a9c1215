import assert from 'node:assert/strict';
import { realpathSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';

import { filesOfProgram, filesOfSandbox, filesOfVision, licencesOf } from './licences.mjs';
import { inRoot } from './repository.mjs';

const vue = join(realpathSync(inRoot('apps/frontend/node_modules/vue')), 'dist/vue.js');

test('a package is listed once, with what it is in', () => {
  const found = licencesOf({ frontend: [vue, `\0${vue}?v=1`], master: [vue], node: [] });
  assert.equal(found.length, 1);
  const [{ name, version, licence, parts, text }] = found;
  assert.deepEqual([name, licence, parts], ['vue', 'MIT', ['frontend', 'master']]);
  assert.match(version, /^\d+\.\d+\.\d+/);
  assert.match(text, /Permission is hereby granted/);
});

test('our own files and files of tools are nobody else’s', () => {
  const ids = [inRoot('apps/master/src/main.ts'), '\0rolldown/runtime.js', '\0plugin-vue:x'];
  assert.deepEqual(licencesOf({ frontend: ids }), []);
});

test('the master has in it what it is bundled from, and no more', async () => {
  const names = licencesOf({ master: await filesOfProgram('apps/master') }).map((one) => one.name);
  for (const name of ['fastify', 'ws', 'qrcode']) assert.ok(names.includes(name), name);
  for (const name of ['yargs', 'esbuild', 'vitest']) assert.ok(!names.includes(name), name);
});

test('the engine of the sandbox is in every part', () => {
  const names = licencesOf({ node: filesOfSandbox() }).map((one) => one.name);
  assert.ok(names.includes('quickjs-emscripten-core'));
});

test('what detects objects is listed, with the package of its models', () => {
  const found = licencesOf({ vision: filesOfVision() });
  const names = found.map((one) => one.name);
  for (const name of ['@tensorflow/tfjs-core', '@vladmandic/human', 'jpeg-js'])
    assert.ok(names.includes(name), name);
  for (const { name, licence } of found) assert.notEqual(licence, 'not told', name);
});

test('every package says under which licence it is', async () => {
  const files = [...(await filesOfProgram('apps/master')), ...(await filesOfProgram('apps/node'))];
  for (const { name, licence } of licencesOf({ master: files })) {
    assert.notEqual(licence, 'not told', name);
  }
});
