import { existsSync } from 'node:fs';

import { run, runNode } from './commands.mjs';
import { inRoot, programFile } from './repository.mjs';
import { StepFailed, expectSuccess } from './steps.mjs';

/** What everything depends on: a change of these can break every package. */
const EVERYWHERE =
  /^(package\.json|pnpm-lock\.yaml|pnpm-workspace\.yaml|tsconfig\.base\.json|vitest\.config\.ts)$/;

/**
 * @typedef {object} Changes
 * @property {string} base commit that the files are compared with
 * @property {readonly string[]} files changed and new files that exist, relative to the root
 * @property {ReadonlySet<string>} packages names of packages with changes, and of those that depend on them
 */

/**
 * What has changed since a commit, committed or not.
 *
 * @param {string} [since] default: where the branch left that of `origin`, else the last commit
 * @returns {Promise<Changes>}
 */
export async function findChanges(since) {
  const base = await baseCommit(since);
  const changed = await git('diff', '--name-only', '-z', base, '--');
  const added = await git('ls-files', '--others', '--exclude-standard', '-z');
  const all = [...new Set(`${changed}${added}`.split('\0'))].filter((file) => file !== '');
  return {
    base,
    files: all.filter((file) => existsSync(inRoot(file))),
    packages: await affectedPackages(all),
  };
}

/** @param {string | undefined} since */
async function baseCommit(since) {
  if (since !== undefined) return (await git('rev-parse', '--verify', `${since}^{commit}`)).trim();
  for (const branch of ['origin/HEAD', 'origin/main']) {
    const { code, output } = await run('git', ['merge-base', 'HEAD', branch]);
    if (code === 0) return output.trim();
  }
  return (await git('rev-parse', 'HEAD')).trim();
}

/** Names of the packages of files, and of those that depend on them. @param {readonly string[]} files relative to the root */
export async function affectedPackages(files) {
  const isEverywhere = files.some((file) => EVERYWHERE.test(file));
  const folders = new Set(files.map(folderOf).filter((folder) => folder !== undefined));
  if (!isEverywhere && folders.size === 0) return new Set();
  const filters = isEverywhere ? [] : [...folders].flatMap((one) => ['--filter', `...{./${one}}`]);
  const { output } = expectSuccess(
    await runNode(programFile('', 'pnpm'), ['list', '-r', '--depth', '-1', '--json', ...filters]),
  );
  /** @type {{ name: string }[]} */
  const packages = JSON.parse(output);
  return new Set(packages.map(({ name }) => name));
}

/** @param {string} file @returns {string | undefined} undefined for files of no package */
export function folderOf(file) {
  const [first = '', second = ''] = file.split('/');
  if (['packages', 'apps', 'demos'].includes(first)) return `${first}/${second}`;
  return ['benchmarks', 'e2e', 'robustness'].includes(first) ? first : undefined;
}

/** @param {...string} args */
async function git(...args) {
  const { code, output } = await run('git', args);
  if (code !== 0) throw new StepFailed(`git ${args.join(' ')}: ${output.trim()}`);
  return output;
}
