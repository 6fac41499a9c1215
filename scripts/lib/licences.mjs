import { existsSync, readdirSync, readFileSync, realpathSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { build } from 'esbuild';

import { inRoot, readJson } from './repository.mjs';

/** Files of a package that say under which conditions it, and what is inside of it, may be used. */
const licenceFile = /^(licen[cs]e|copying|notice|third-?party)/i;

/**
 * One package of others that we ship.
 *
 * @typedef {object} PackageLicence
 * @property {string} name
 * @property {string} version
 * @property {string} licence SPDX expression
 * @property {string} author who is named in its manifest; empty when nobody is
 * @property {string} url where it comes from; empty when it does not say so
 * @property {string[]} parts which of `frontend`, `master`, `node`, `bridge`, `vision` have it in them
 * @property {string} text its licence files, one after the other; empty when it brings none
 */

/**
 * Packages of others with code or files in what people get.
 *
 * @param {Readonly<Record<string, Iterable<string>>>} filesByPart absolute paths of what each part is made from
 * @returns {PackageLicence[]} by name
 */
export function licencesOf(filesByPart) {
  const found = new Map();
  for (const [part, files] of Object.entries(filesByPart)) {
    for (const folder of new Set([...files].map(packageFolder))) {
      if (folder === undefined) continue;
      const entry = describe(folder);
      const key = `${entry.name} ${entry.version}`;
      const known = found.get(key) ?? { ...entry, parts: [] };
      if (!known.parts.includes(part)) known.parts.push(part);
      found.set(key, known);
    }
  }
  return [...found.values()].sort(
    (a, b) => a.name.localeCompare(b.name, 'en') || a.version.localeCompare(b.version, 'en'),
  );
}

/**
 * Files that are bundled into a program for Node; the bundle is built for this list only, not written.
 *
 * @param {string} folder of the program, relative to the root
 * @returns {Promise<string[]>} absolute paths
 */
export async function filesOfProgram(folder) {
  const { metafile } = await build({
    absWorkingDir: inRoot(),
    entryPoints: [inRoot(folder, 'src/main.ts')],
    outdir: inRoot(folder, 'dist'),
    bundle: true,
    write: false,
    metafile: true,
    platform: 'node',
    format: 'esm',
    splitting: true,
    external: ['bufferutil', 'utf-8-validate'],
    logLevel: 'silent',
  });
  return [
    ...Object.values(metafile.outputs).flatMap(({ inputs }) =>
      Object.keys(inputs).filter((file) => inputs[file].bytesInOutput > 0),
    ),
  ].map((file) => inRoot(file));
}

/** Manifests of the folders whose packages are bundled into the workers of processing modules. */
export function filesOfSandbox() {
  return foldersBelow(inRoot('packages/pm-sandbox')).map((folder) => join(folder, 'package.json'));
}

/** Manifests of the packages that the library of vision and the asset sets are built from. */
export function filesOfVision() {
  const own = inRoot('packages/vision');
  const ofSets = ['@vladmandic/human', '@techstark/opencv-js'].map((name) =>
    resolveFrom(own, name),
  );
  return [...foldersBelow(own), ...ofSets].map((folder) => join(folder, 'package.json'));
}

/**
 * Vite plugin: adds `/licences.json` to the build, with everything in it, in its workers, and in the
 * programs that are shipped with it. Development serves none: what is in a build is known after it.
 *
 * @returns {{ plugin: object, workerPlugin: () => object }} for `plugins` and for `worker.plugins`
 */
export function licencesPlugins() {
  const files = new Set();
  const collect = (bundle) => {
    for (const output of Object.values(bundle)) {
      for (const id of Object.keys(output.modules ?? {})) files.add(id);
      for (const name of output.originalFileNames ?? []) files.add(inRoot('apps/frontend', name));
    }
  };
  return {
    workerPlugin: () => ({
      name: 'ubii-licences-of-workers',
      generateBundle: (_options, bundle) => collect(bundle),
    }),
    plugin: {
      name: 'ubii-licences',
      apply: 'build',
      async generateBundle(_options, bundle) {
        collect(bundle);
        // Of some, such as vue, nothing is left but what they pass on from others
        const { dependencies } = readJson(inRoot('apps/frontend/package.json'));
        for (const id of this.getModuleIds()) {
          const folder = packageFolder(id);
          if (folder !== undefined && manifestOf(folder).name in dependencies) files.add(id);
        }
        const sandbox = filesOfSandbox();
        const packages = licencesOf({
          frontend: [...files, ...sandbox],
          master: [...(await filesOfProgram('apps/master')), ...sandbox],
          node: [...(await filesOfProgram('apps/node')), ...sandbox],
          bridge: await filesOfProgram('apps/bridge'),
          vision: filesOfVision(),
        });
        const own = { ...describe(inRoot()), name: 'Ubi-Interact' };
        const source = JSON.stringify({ own, packages });
        this.emitFile({ type: 'asset', fileName: 'licences.json', source });
      },
    },
  };
}

/** The folder of the package a file belongs to; undefined for files of our own. */
function packageFolder(file) {
  const path = file.replace(/^\0/, '').replace(/\?.*$/, '').replaceAll('\\', '/');
  return /^.*\/node_modules\/(?:@[^/]+\/)?[^/@.][^/]*/.exec(path)?.[0];
}

/** Real folders of all packages of others below one of ours. */
function foldersBelow(start) {
  const seen = new Set();
  const others = [];
  const waiting = [realpathSync(start)];
  for (let folder = waiting.pop(); folder !== undefined; folder = waiting.pop()) {
    if (seen.has(folder)) continue;
    seen.add(folder);
    const { name, dependencies = {}, optionalDependencies = {} } = manifestOf(folder);
    if (!name.startsWith('@ubii/')) others.push(folder);
    for (const dependency of Object.keys({ ...dependencies, ...optionalDependencies })) {
      const next = resolveFrom(folder, dependency);
      if (next !== undefined) waiting.push(next);
      // A missing optional dependency may be for another system
      else if (!(dependency in optionalDependencies)) {
        throw new Error(
          `${dependency}, which ${name} needs, is not installed: run npm start again.`,
        );
      }
    }
  }
  return others;
}

function resolveFrom(folder, name) {
  for (let at = folder; at !== dirname(at); at = dirname(at)) {
    const candidate = join(at, 'node_modules', name);
    if (existsSync(join(candidate, 'package.json'))) return realpathSync(candidate);
  }
  return undefined;
}

function describe(folder) {
  const { name, version, license, licenses, author, homepage, repository } = manifestOf(folder);
  const told = license ?? licenses?.map(({ type }) => type).join(' OR ');
  return {
    name,
    version,
    licence: (typeof told === 'string' ? told : told?.type) ?? 'not told',
    author: (typeof author === 'string' ? author : author?.name) ?? '',
    url: webAddress(homepage ?? (typeof repository === 'string' ? repository : repository?.url)),
    text: readdirSync(folder)
      .filter((file) => licenceFile.test(file) && !/\.[cm]?[jt]s$/.test(file))
      .sort()
      .map((file) => readFileSync(join(folder, file), 'utf8').replaceAll('\r\n', '\n').trim())
      .join('\n\n'),
  };
}

/** `git+https://github.com/a/b.git` and `github:a/b` as a page. */
function webAddress(text = '') {
  const address = text
    .replace(/^git\+/, '')
    .replace(/^(github:)?([\w.-]+\/[\w.-]+)$/, 'https://github.com/$2')
    .replace(/^(git|ssh):\/\/(git@)?/, 'https://')
    .replace(/\.git$/, '');
  return /^https?:\/\//.test(address) ? address : '';
}

function manifestOf(folder) {
  return readJson(join(folder, 'package.json'));
}
