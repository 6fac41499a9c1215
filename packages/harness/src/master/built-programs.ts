import { execFileSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { join, resolve } from 'node:path';

const REPOSITORY = resolve(import.meta.dirname, '../../../..');
const APPS = join(REPOSITORY, 'apps');
const MASTER_FOLDER = join(APPS, 'master');
const TEST_FOLDER = join(MASTER_FOLDER, '.cache-robustness');

/** The master as `npm run build` leaves it. */
export const BUILT_MASTER = builtProgram('master');

/** The node as `npm run build` leaves it. */
export const BUILT_NODE = builtProgram('node');

/** The master that `buildMasterForTests` builds from the sources as they are now. */
export const MASTER_FOR_TESTS = join(TEST_FOLDER, 'main.js');

/** Returns the main file of a program as `npm run build` leaves it. @param app its folder in `apps/` */
export function builtProgram(app: 'master' | 'node' | 'bridge'): string {
  return join(APPS, app, 'dist', 'main.js');
}

/**
 * Builds the master from its sources, which takes some two seconds.
 *
 * @param folder output; its parent has the `package.json` that the master reads its version from
 * @returns its main file
 */
export function buildMaster(folder: string): string {
  execFileSync(process.execPath, [join(MASTER_FOLDER, 'build.mjs'), folder], { stdio: 'inherit' });
  return join(folder, 'main.js');
}

/** Builds `MASTER_FOR_TESTS`: once for all test files, which run in parallel. */
export function buildMasterForTests(): void {
  buildMaster(TEST_FOLDER);
}

/** @throws Error when the program is missing */
export function expectBuilt(program: string): void {
  if (existsSync(program)) return;
  throw new Error(`There is no program at ${program}. Run \`npm run build\` first.`);
}

const helpTexts = new Map<string, string>();

/** Returns whether a build knows a flag: builds of different commits are compared with each other. */
export function hasFlag(program: string, flag: string): boolean {
  expectBuilt(program);
  let text = helpTexts.get(program);
  if (text === undefined) {
    text = execFileSync(process.execPath, [program, '--help'], { encoding: 'utf8' });
    helpTexts.set(program, text);
  }
  return text.includes(`${flag} `) || text.includes(`${flag}\n`);
}

/** Returns whether the program was built in this repository, so that its flags are known. */
export function isOwnBuild(program: string): boolean {
  return resolve(program).startsWith(join(REPOSITORY, '/'));
}
