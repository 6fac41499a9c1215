import { readFileSync, readdirSync } from 'node:fs';
import { extname, join, sep } from 'node:path';

import { inRoot } from '../repository.mjs';
import { markdownPassages } from './markdown-passages.mjs';
import { commentPassages } from './passages.mjs';
import { typescriptPassages } from './typescript-passages.mjs';
import { vuePassages } from './vue-passages.mjs';

/** Kinds of texts; titles are those of tests, messages are errors and lines of logs. */
export const PLACES = /** @type {const} */ (['docs', 'comments', 'screens', 'messages', 'titles']);

/** @typedef {(typeof PLACES)[number]} Place */

/** Folders with nothing that is written by hand, besides hidden ones; as paths from the root. */
const notWritten =
  /(^|\/)(node_modules|dist|generated)$|^(data|(benchmarks|robustness)\/results|e2e\/(playwright-report|test-results))$/;

const screens = /^(apps\/frontend|demos\/[^/]+)\/src\//;
/** Other texts there are examples: what people type, what a program answers. */
const tests = /\.(test|spec)\.|^e2e\/|\/test\/|\/testing\//;

const readers = {
  '.md': markdownPassages,
  '.ts': typescriptPassages,
  '.mjs': typescriptPassages,
  '.js': typescriptPassages,
  '.vue': vuePassages,
  '.proto': (source) => commentPassages(source),
  '.css': (source) => commentPassages(source),
};

/**
 * Reads all files that people write.
 *
 * @returns {{ path: string, source: string }[]} paths relative to the root, with `/`
 */
export function writtenFiles() {
  return pathsIn('').map((path) => ({ path, source: readFileSync(inRoot(path), 'utf8') }));
}

/** @param {string} folder relative to the root @returns {string[]} */
function pathsIn(folder) {
  return readdirSync(inRoot(folder), { withFileTypes: true }).flatMap((entry) => {
    const path = join(folder, entry.name).split(sep).join('/');
    if (entry.name.startsWith('.') || notWritten.test(path)) return [];
    if (entry.isDirectory()) return pathsIn(path);
    return extname(path) in readers ? [path] : [];
  });
}

/**
 * Finds what people read in a file. Texts of tests that are no titles are left out.
 *
 * @param {string} path @param {string} source
 * @returns {(import('./passages.mjs').Passage & { place: Place })[]}
 */
export function passagesOf(path, source) {
  return readers[extname(path)](source)
    .map((passage) => ({ ...passage, place: placeOf(path, passage.kind) }))
    .filter(({ place }) => place !== undefined);
}

/** @returns {Place | undefined} */
function placeOf(path, kind) {
  if (path.endsWith('.md')) return 'docs';
  if (kind === 'comment') return 'comments';
  if (kind === 'title') return 'titles';
  if (tests.test(path)) return undefined;
  return screens.test(path) ? 'screens' : 'messages';
}
