import assert from 'node:assert/strict';
import { test } from 'node:test';

import { installedLicences } from './dependency-licences.mjs';
import { readLock } from './lockfile.mjs';
import { inRoot, readJson } from './repository.mjs';
import { createSbom } from './sbom.mjs';

const own = readJson(inRoot('package.json'));
const create = () => createSbom(readLock(), own, installedLicences());

test('every locked package is in it, with version, hash and licence', () => {
  const { components } = create();
  assert.equal(components.length, readLock().packages.size);
  const fastify = components.find(({ name, group }) => name === 'fastify' && group === undefined);
  const { version } = [...readLock().packages.values()].find(({ name }) => name === 'fastify');
  assert.equal(fastify.purl, `pkg:npm/fastify@${version}`);
  assert.equal(fastify.scope, 'required');
  assert.deepEqual(fastify.licenses, [{ expression: 'MIT' }]);
  assert.equal(fastify.hashes[0].alg, 'SHA-512');
  assert.match(fastify.hashes[0].content, /^[0-9a-f]{128}$/);
});

test('tools are told from what people get, and scopes are written as they have to be', () => {
  const { components } = create();
  const vitest = components.find(({ name, group }) => name === 'vitest' && group === undefined);
  assert.equal(vitest.scope, 'excluded');
  const scoped = components.find(({ group }) => group === '@fastify');
  assert.ok(scoped.purl.startsWith('pkg:npm/%40fastify/'));
});

test('each reference is to something that is in it, and named once', () => {
  const { components, dependencies, metadata } = create();
  const refs = [metadata.component, ...components].map((component) => component['bom-ref']);
  assert.equal(new Set(refs).size, refs.length);
  assert.deepEqual(
    dependencies.map(({ ref }) => ref),
    refs,
  );
  const known = new Set(refs);
  for (const { dependsOn } of dependencies) for (const ref of dependsOn) assert.ok(known.has(ref));
});

test('the same lockfile gives the same text', () => {
  assert.equal(JSON.stringify(create()), JSON.stringify(create()));
});
