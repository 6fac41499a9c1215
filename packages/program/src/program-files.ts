import { homedir } from 'node:os';
import { join } from 'node:path';
import { existsSync, readFileSync } from 'node:fs';

import type { Environment } from './read-options.ts';

const NAME = 'ubi-interact';

/** Returns the folder for data that a user keeps, as the system has it for its programs. */
export function userDataFolder(
  env: Environment = process.env,
  platform: string = process.platform,
  home: string = homedir(),
): string {
  switch (platform) {
    case 'darwin':
      return join(home, 'Library', 'Application Support', NAME);
    case 'win32':
      return join(env['LOCALAPPDATA'] ?? join(home, 'AppData', 'Local'), NAME);
    default:
      // XDG Base Directory Specification: an unset or empty variable means ~/.local/share.
      return join(env['XDG_DATA_HOME'] || join(home, '.local', 'share'), NAME);
  }
}

/** Returns the folder for state that outlives a run of a program, and is of use on this machine only. */
export function userStateFolder(env: Environment = process.env, home: string = homedir()): string {
  // XDG Base Directory Specification; an unset or empty variable means ~/.local/state.
  return join(env['XDG_STATE_HOME'] || join(home, '.local', 'state'), NAME);
}

/**
 * Returns the version in the `package.json` one folder above a file, which is the same from `src` and from `dist`.
 *
 * @param programUrl `import.meta.url` of the file
 */
export function readVersion(programUrl: string): string {
  const manifest = readFileSync(new URL('../package.json', programUrl), 'utf8');
  return (JSON.parse(manifest) as { version: string }).version;
}

/** Returns the folder of the person who ran an npm script, which npm runs in the folder of its package. */
export function callerFolder(): string {
  return process.env['INIT_CWD'] ?? process.cwd();
}

/**
 * Returns a file that is built beside a program. A program that runs from its sources uses the last build.
 *
 * @param programUrl `import.meta.url` of a file of the program
 */
export function findBuilt(name: string, programUrl: string): URL {
  const beside = new URL(name, programUrl);
  return existsSync(beside) ? beside : new URL(`../dist/${name}`, programUrl);
}
