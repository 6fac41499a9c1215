import { join } from 'node:path';

import { runNode } from './commands.mjs';
import { nameComponents, writeComponentScripts } from './component-scripts.mjs';
import { cacheFolder, inRoot, programFile } from './repository.mjs';
import { expectSuccess } from './steps.mjs';

/** Folders with TypeScript; oxlint would walk through node_modules as well. */
const SOURCES = ['packages', 'apps', 'demos', 'benchmarks', 'e2e', 'robustness'];

const OXLINT_FLAGS = [
  ...['--config', 'oxlint.config.mjs', '--no-error-on-unmatched-pattern'],
  ...['--report-unused-disable-directives-severity', 'error'],
];

const WITH_COMPONENTS = ['apps/frontend', 'demos/ubi-party'];

/**
 * The rules that need one file each: with oxlint for TypeScript, with ESLint for the rest. That is why the results of ESLint
 * can be kept between runs on one machine; CI begins without.
 *
 * @param {readonly string[]} [files] default: all
 */
export async function lintSources(files = ['.']) {
  expectSuccess(await runNode(programFile('', 'oxlint'), [...OXLINT_FLAGS, ...files]));
  const config = ['--config', 'scripts/lib/eslint-rest.config.mjs'];
  const flags = ['--max-warnings', '0', '--no-warn-ignored', ...cacheFlags()];
  expectSuccess(await runNode(programFile('', 'eslint'), [...files, ...config, ...flags]));
}

/** oxlint, with the rules that need types, for all but components. @param {readonly string[]} [files] default: all */
export async function lintTypesOfFiles(files = SOURCES) {
  expectSuccess(await runNode(programFile('', 'oxlint'), ['--type-aware', ...files]));
}

/**
 * The same for the scripts of components, which oxlint reads with their types only as files of TypeScript. All of them: that
 * takes seconds.
 */
export async function lintTypesOfComponents() {
  for (const folder of WITH_COMPONENTS) {
    const { cwd, files } = writeComponentScripts(folder);
    // Named one by one: in folders it leaves out what git ignores.
    const args = ['--config', inRoot('.oxlintrc.json'), '--no-ignore', '--type-aware', ...files];
    const { code, output } = await runNode(programFile('', 'oxlint'), args, { cwd });
    expectSuccess({ code, output: nameComponents(output, folder) });
  }
}

/** @param {readonly string[]} [files] default: all */
export async function checkFormat(files = ['.']) {
  const args = ['--list-different', '--no-error-on-unmatched-pattern', ...files];
  expectSuccess(await runNode(programFile('', 'oxfmt'), args));
}

function cacheFlags() {
  if (process.env.CI) return [];
  const place = ['--cache', '--cache-location', join(cacheFolder, 'eslint')];
  // Dates of files say nothing after a change of branch.
  return [...place, '--cache-strategy', 'content'];
}
