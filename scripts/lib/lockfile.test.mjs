import assert from 'node:assert/strict';
import { test } from 'node:test';

import { parseLock, productionPackages, readLock } from './lockfile.mjs';

const SMALL = `lockfileVersion: '9.0'

importers:

  .:
    devDependencies:
      tool:
        specifier: 1.0.0
        version: 1.0.0

  apps/a:
    dependencies:
      '@ubii/own':
        specifier: workspace:*
        version: link:../../packages/own
      '@scope/lib':
        specifier: ^2.0.0
        version: 2.1.0(peer@3.0.0)

packages:

  '@scope/lib@2.1.0':
    resolution: {integrity: sha512-AAAA}
    engines: {npm: '>=9', node: ^20.19.0 || >=22}
    peerDependencies:
      peer: '*'

  binding@1.0.0:
    resolution: {integrity: sha512-BBBB}
    os: [win32]

  below-binding@1.0.0:
    resolution: {integrity: sha512-CCCC}

  peer@3.0.0:
    resolution: {integrity: sha512-DDDD}
    engines: {node: '>= 18'}

  tool@1.0.0:
    resolution: {integrity: sha512-EEEE}

snapshots:

  '@scope/lib@2.1.0(peer@3.0.0)':
    dependencies:
      peer: 3.0.0
    optionalDependencies:
      binding: 1.0.0

  binding@1.0.0:
    dependencies:
      below-binding: 1.0.0

  below-binding@1.0.0: {}

  peer@3.0.0: {}

  tool@1.0.0: {}
`;

test('a lockfile is read with what each package needs', () => {
  const { packages, importers } = parseLock(SMALL);
  assert.deepEqual(packages.get('@scope/lib@2.1.0'), {
    name: '@scope/lib',
    version: '2.1.0',
    integrity: 'sha512-AAAA',
    nodeRange: '^20.19.0 || >=22',
    isForSomeSystems: false,
    dependencies: ['binding@1.0.0', 'peer@3.0.0'],
  });
  assert.deepEqual(importers.get('apps/a'), {
    production: ['@scope/lib@2.1.0'],
    development: [],
  });
});

test('a package says which versions of Node it asks for', () => {
  const { packages } = parseLock(SMALL);
  assert.equal(packages.get('peer@3.0.0').nodeRange, '>= 18');
  assert.equal(packages.get('tool@1.0.0').nodeRange, '');
});

test('what people get is told from tools', () => {
  const production = productionPackages(parseLock(SMALL));
  assert.ok(production.has('peer@3.0.0'));
  assert.ok(!production.has('tool@1.0.0'));
});

test('what only packages for some systems need is for some systems', () => {
  const { packages } = parseLock(SMALL);
  const some = [...packages.values()].filter(({ isForSomeSystems }) => isForSomeSystems);
  assert.deepEqual(
    some.map(({ name }) => name),
    ['below-binding', 'binding'],
  );
});

test('a lockfile of another version is refused', () => {
  assert.throws(() => parseLock("lockfileVersion: '6.0'\n"), /version 9.0/);
});

test('ours is read as a whole', () => {
  const lock = readLock();
  const production = productionPackages(lock);
  for (const name of ['fastify', 'ws', 're2js', 'vue']) {
    assert.ok(
      [...production].some((key) => key.startsWith(`${name}@`)),
      name,
    );
  }
  for (const { name, integrity } of lock.packages.values())
    assert.match(integrity, /^sha512-/, name);
});
