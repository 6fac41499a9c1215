import { existsSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

/** Absolute path of the repository's root. */
export const root = join(dirname(fileURLToPath(import.meta.url)), '..', '..');

/** Stamps and reports of the scripts; ignored by git, safe to delete. */
export const cacheFolder = join(root, '.cache');

/** @param {...string} parts path relative to the root */
export function inRoot(...parts) {
  return join(root, ...parts);
}

/** @param {string} path absolute */
export function readJson(path) {
  return JSON.parse(readFileSync(path, 'utf8'));
}

/**
 * Path of a program's JavaScript file, to be run with Node itself: works the same on every system,
 * without shell and without `pnpm` on the path.
 *
 * @param {string} folder workspace folder that declares the dependency, '' for the root
 * @param {string} packageName
 * @param {string} [program] name of the program, when it differs from the package's
 */
export function programFile(folder, packageName, program = packageName) {
  const packageFolder = inRoot(folder, 'node_modules', packageName);
  const manifestFile = join(packageFolder, 'package.json');
  if (!existsSync(manifestFile)) {
    throw new Error(
      `${packageName} is not installed in ${folder || 'the root'}: add it to its package.json and run npm start again.`,
    );
  }
  const { bin } = readJson(manifestFile);
  return join(packageFolder, typeof bin === 'string' ? bin : bin[program]);
}
