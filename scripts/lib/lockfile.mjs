import { readFileSync } from 'node:fs';

import { inRoot } from './repository.mjs';

/**
 * One version of a package of others.
 *
 * @typedef {object} LockedPackage
 * @property {string} name
 * @property {string} version
 * @property {string} integrity as npm writes it, such as `sha512-…`; empty when the lockfile has none
 * @property {string} nodeRange the versions of Node that it asks for, as npm writes a range; empty when it asks for none
 * @property {boolean} isForSomeSystems it, or all that needs it, is for some systems or processors only
 * @property {string[]} dependencies `name@version` of what it needs
 */

/**
 * The parsed lockfile.
 *
 * @typedef {object} Lock
 * @property {Map<string, LockedPackage>} packages by `name@version`, in the order of their names
 * @property {Map<string, { production: string[], development: string[] }>} importers our own packages by their folder
 */

/** The lockfile of this repository. @returns {Lock} */
export function readLock() {
  return parseLock(readFileSync(inRoot('pnpm-lock.yaml'), 'utf8'));
}

/**
 * Reads a lockfile of pnpm, version 9.
 *
 * @param {string} text
 * @returns {Lock}
 */
export function parseLock(text) {
  const lock = parseBlocks(text);
  if (lock.lockfileVersion !== '9.0') {
    throw new Error(`Expected a lockfile of version 9.0, received ${lock.lockfileVersion}`);
  }
  const packages = new Map();
  for (const key of Object.keys(lock.packages).sort()) {
    const { name, version } = splitKey(key);
    const { resolution, engines = '', os, cpu } = lock.packages[key];
    const [, integrity = ''] = /integrity: ([^,}]+)/.exec(resolution) ?? [];
    const [, quoted, nodeRange = quoted ?? ''] = nodeOfEngines.exec(engines) ?? [];
    const isForSomeSystems = os !== undefined || cpu !== undefined;
    packages.set(key, { name, version, integrity, nodeRange, isForSomeSystems, dependencies: [] });
  }
  for (const [key, snapshot] of Object.entries(lock.snapshots)) {
    const entry = packages.get(withoutPeers(key));
    if (entry === undefined) throw new Error(`${key} has no entry under packages`);
    const { dependencies = {}, optionalDependencies = {} } = snapshot;
    const needed = keysOf({ ...dependencies, ...optionalDependencies });
    entry.dependencies = [...new Set([...entry.dependencies, ...needed])].sort();
  }
  const importers = new Map();
  for (const [folder, importer] of Object.entries(lock.importers)) {
    const { dependencies = {}, optionalDependencies = {}, devDependencies = {} } = importer;
    importers.set(folder, {
      production: keysOf(versionsOf({ ...dependencies, ...optionalDependencies })),
      development: keysOf(versionsOf(devDependencies)),
    });
  }
  const always = neededBy(
    { packages, importers },
    [...importers.values()].flatMap(({ production, development }) => [
      ...production,
      ...development,
    ]),
    ({ isForSomeSystems }) => !isForSomeSystems,
  );
  for (const [key, entry] of packages) if (!always.has(key)) entry.isForSomeSystems = true;
  return { packages, importers };
}

/**
 * Packages that something needs, with all that they need.
 *
 * @param {Lock} lock
 * @param {Iterable<string>} start `name@version`
 * @param {(entry: LockedPackage) => boolean} isMeant leaves out others, and what only they need
 * @returns {Set<string>} `name@version`
 */
export function neededBy(lock, start, isMeant = () => true) {
  const found = new Set();
  const waiting = [...start];
  for (let key = waiting.pop(); key !== undefined; key = waiting.pop()) {
    const entry = lock.packages.get(key);
    if (entry === undefined) throw new Error(`${key} is needed, but not locked`);
    if (found.has(key) || !isMeant(entry)) continue;
    found.add(key);
    waiting.push(...entry.dependencies);
  }
  return found;
}

/** `{node: '>=18', npm: '>=9'}`, where quotes stand only around what needs them. */
const nodeOfEngines = /[{ ]node: (?:'([^']*)'|([^',}]+))/;

/** Folders of ours that people get; the others are tools and tests. */
const handedOn = /^(?:apps|packages)\//;

/** Packages in what people get. @param {Lock} lock @returns {Set<string>} `name@version` */
export function productionPackages({ packages, importers }) {
  const start = [...importers].flatMap(([folder, { production }]) =>
    handedOn.test(folder) ? production : [],
  );
  return neededBy({ packages, importers }, start);
}

/** @param {Record<string, { version: string }>} dependencies */
function versionsOf(dependencies) {
  return Object.fromEntries(
    Object.entries(dependencies).map(([name, { version }]) => [name, version]),
  );
}

/** @param {Record<string, string>} versions by name */
function keysOf(versions) {
  return Object.entries(versions)
    .filter(([, version]) => !version.startsWith('link:'))
    .map(([name, version]) => {
      const plain = withoutPeers(version);
      // Of an alias the lockfile has the whole key
      return plain.includes('@') ? plain : `${name}@${plain}`;
    })
    .sort();
}

/** `a@1.0.0(b@2.0.0)` as `a@1.0.0`. @param {string} key */
function withoutPeers(key) {
  const end = key.indexOf('(');
  return end === -1 ? key : key.slice(0, end);
}

/** @param {string} key */
function splitKey(key) {
  const at = key.lastIndexOf('@');
  return { name: key.slice(0, at), version: key.slice(at + 1) };
}

/** The part of YAML that pnpm writes: blocks of keys by indentation. Flow collections stay text. */
function parseBlocks(text) {
  const root = {};
  const open = [{ indent: -1, block: root }];
  for (const line of text.split('\n')) {
    const parts = /^( *)(?:'([^']+)'|([^\s'][^:]*(?::[^\s:][^:]*)*)):(?: (.*))?$/.exec(line);
    if (parts === null) continue; // empty, or an element of a list, which nothing here needs
    const indent = parts[1].length;
    const key = parts[2] ?? parts[3];
    while (open.at(-1).indent >= indent) open.pop();
    const value = parts[4];
    if (value === undefined) {
      const block = {};
      open.at(-1).block[key] = block;
      open.push({ indent, block });
    } else {
      open.at(-1).block[key] = value === '{}' ? {} : value.replace(/^'(.*)'$/, '$1');
    }
  }
  return root;
}
