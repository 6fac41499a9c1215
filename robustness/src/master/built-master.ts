import { execFileSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const masterFolder = fileURLToPath(new URL('../../../apps/master/', import.meta.url));

/** The master as `npm run build` leaves it. */
export const BUILT_MASTER = join(masterFolder, 'dist', 'main.js');

/** The node as `npm run build` leaves it. */
export const BUILT_NODE = join(masterFolder, '..', 'node', 'dist', 'main.js');

const TEST_FOLDER = '.cache-robustness';

/** The master that tests of the gate start: built from the sources as they are now. */
export const MASTER_FOR_TESTS = join(masterFolder, TEST_FOLDER, 'main.js');

/** Builds it, in some two seconds: once for all files of tests, which run side by side. */
export function buildMasterForTests(): void {
  execFileSync(process.execPath, ['build.mjs', TEST_FOLDER], { cwd: masterFolder });
}

const helpTexts = new Map<string, string>();

/** Whether a build knows a flag: builds of different commits are compared with each other. */
export function hasFlag(program: string, flag: string): boolean {
  if (!existsSync(program)) {
    throw new Error(`There is no master at ${program}. Run \`npm run build\` first.`);
  }
  let text = helpTexts.get(program);
  if (text === undefined) {
    text = execFileSync(process.execPath, [program, '--help'], { encoding: 'utf8' });
    helpTexts.set(program, text);
  }
  return text.includes(`${flag} `) || text.includes(`${flag}\n`);
}
