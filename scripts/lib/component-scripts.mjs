import { mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';

import { inRoot } from './repository.mjs';

/** Folder in a package for the scripts of its components, as files of TypeScript. */
const SCRIPTS = '.cache/component-scripts';

const SCRIPT = /<script\b[^>]*\blang="ts"[^>]*>([\s\S]*?)<\/script>/g;

/** The scripts of a component at their lines and columns; all else is blank. @param {string} source */
export function scriptOf(source) {
  const blank = (/** @type {string} */ text) => text.replace(/[^\r\n]/g, ' ');
  let script = '';
  let end = 0;
  for (const match of source.matchAll(SCRIPT)) {
    const [block, code = ''] = match;
    const start = match.index + block.indexOf('>') + 1;
    script += blank(source.slice(end, start)) + code;
    end = start + code.length;
  }
  return script + blank(source.slice(end));
}

/**
 * Writes the scripts of a package's components beside its sources, so that tools which read TypeScript alone find their types:
 * `src/a/B.vue` becomes `.cache/component-scripts/src/a/B.vue.ts`.
 *
 * @param {string} folder of the package, relative to the root
 * @returns {{ cwd: string, files: string[] }} the folder of the scripts, absolute, and their paths in it
 */
export function writeComponentScripts(folder) {
  const cwd = inRoot(folder, SCRIPTS);
  rmSync(cwd, { recursive: true, force: true });
  const files = readdirSync(inRoot(folder, 'src'), { recursive: true, encoding: 'utf8' })
    .filter((name) => name.endsWith('.vue'))
    .map((name) => {
      const file = join('src', `${name}.ts`);
      mkdirSync(dirname(join(cwd, file)), { recursive: true });
      writeFileSync(join(cwd, file), scriptOf(readFileSync(inRoot(folder, 'src', name), 'utf8')));
      return file;
    });
  const config = {
    extends: '../../tsconfig.json',
    // Both trees are one: imports of the scripts lead to the sources.
    compilerOptions: { rootDirs: ['../../src', './src'], incremental: false },
    include: ['./src', '../../src/**/*.d.ts'],
  };
  writeFileSync(join(cwd, 'tsconfig.json'), JSON.stringify(config));
  return { cwd, files };
}

/** A text about scripts in which components have their own paths again. @param {string} text @param {string} folder of the package */
export function nameComponents(text, folder) {
  return text.replace(/(\bsrc[/\\][\w./\\-]+?\.vue)\.ts\b/g, join(folder, '$1'));
}
