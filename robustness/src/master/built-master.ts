import { execFileSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const masterFolder = fileURLToPath(new URL('../../../apps/master/', import.meta.url));

/** The master as `npm run build` leaves it. */
export const BUILT_MASTER = join(masterFolder, 'dist', 'main.js');

/** The node as `npm run build` leaves it. */
export const BUILT_NODE = join(masterFolder, '..', 'node', 'dist', 'main.js');

/** Builds the master from the sources as they are now, for tests of the gate; takes some two seconds. */
export function buildForTests(): string {
  const folder = '.cache-robustness';
  execFileSync(process.execPath, ['build.mjs', folder], { cwd: masterFolder });
  return join(masterFolder, folder, 'main.js');
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
